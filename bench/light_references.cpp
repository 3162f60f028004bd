#include "bench/light_references.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <utility>

#include "bench/light_figures.hpp"
#include "core/fingerprint.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/image/picture_file.hpp"
#include "trace/strip_order.hpp"

namespace lippmann::bench {
namespace {

constexpr int kProbeSamples = 2;
constexpr std::size_t kBlockPixels = 16 * kPacketsPerBlock;  // touched_blocks.hpp

/// Whole rows lie in few blocks when these go row by row.
std::vector<std::uint8_t> blocks_with_rows(const Optics& optics, const std::vector<int>& rows) {
  const StripOrder order = make_strip_order(optics, RayOrder::kRows);
  const std::size_t blocks = (order.pixels.size() + kBlockPixels - 1) / kBlockPixels;
  const int strips = (optics.panel.height + order.strip_height - 1) / order.strip_height;
  std::vector<std::uint8_t> wanted(static_cast<std::size_t>(strips) * blocks, 0);
  for (const int row : rows)
    for (std::size_t p = 0; p < order.pixels.size(); ++p)
      if (order.pixels[p].y == row % order.strip_height)
        wanted[static_cast<std::size_t>(row / order.strip_height) * blocks + p / kBlockPixels] = 1;
  return wanted;
}

std::optional<Image8> read_kept(const std::filesystem::path& file, int width, std::size_t rows) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  try {
    Picture picture = read_picture(file);
    auto* codes = std::get_if<Image8>(&picture);
    if (codes && codes->width == width && static_cast<std::size_t>(codes->height) == rows) return std::move(*codes);
  } catch (const Error&) {  // damaged: as if it were not there
  }
  return std::nullopt;
}

}  // namespace

std::filesystem::path default_reference_folder() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache)
    return std::filesystem::path(cache) / "lippmann" / "references";
  if (const char* home = std::getenv("HOME"); home && *home)
    return std::filesystem::path(home) / ".cache" / "lippmann" / "references";
  throw usage_error("--references", "neither XDG_CACHE_HOME nor HOME says where to keep references", "a folder");
}

LightReferences::LightReferences(Stage& stage, const RenderParams& params, std::vector<int> rows, std::filesystem::path folder,
                                 const ThreadPool& pool, const Context& context, std::function<void(std::string_view)> say)
    : stage_(stage),
      params_(params),
      rows_(std::move(rows)),
      folder_(std::move(folder)),
      pool_(pool),
      context_(context),
      say_(std::move(say)),
      wanted_(blocks_with_rows(stage.placed.optics, rows_)),
      film_(stage.placed.optics.panel.width, stage.placed.optics.panel.height, 3) {}

Image8 LightReferences::trace(const RenderParams& params, int frame, int spp) {
  const Moment moment = stage_.moment_at(frame);
  TraceParams trace = trace_params(params.sampling, stage_);
  trace.order = RayOrder::kRows;
  trace.frame = static_cast<std::uint32_t>(frame);
  trace.spp = spp;
  trace_blocks(stage_.shot(moment), trace, wanted_, {pool_, context_}, film_);
  return take_rows(to_codes(film_, stage_.scene.encoding), rows_);
}

/// Whatever changes light or rays, be it in the scene, in the optics or in this program, changes some bit of a few samples of
/// some thousands of pixels.
std::uint64_t LightReferences::fingerprint_of(const RenderParams& params, int frame) {
  trace(params, frame, kProbeSamples);
  Fingerprint print;
  for (const int row : rows_) print.add_bytes(film_.pixel(0, row), 3 * sizeof(float) * static_cast<std::size_t>(film_.width));
  const TraceParams trace = trace_params(params.sampling, stage_);
  print.add(trace.spp);
  print.add(trace.max_depth);
  print.add(stage_.scene.encoding);
  return print.value();
}

Reference LightReferences::frame(int frame) {
  stage_.device.update(stage_.moment_at(frame).resolved, pool_);
  RenderParams first = params_;
  first.sampling.spp = std::max(1, samples_per_pixel(params_.sampling) / 2);
  RenderParams second = first;
  second.sampling.seed += 1;
  return {half(first, frame), half(second, frame)};
}

Image8 LightReferences::half(const RenderParams& params, int frame) {
  const std::string scene = std::filesystem::path(params_.scene.name).stem().string();
  const auto file = folder_ / fmt::format("{}_{:04}_{:016x}.png", scene, frame, fingerprint_of(params, frame));
  if (auto codes = read_kept(file, film_.width, rows_.size())) {
    ++kept_;
    return std::move(*codes);
  }
  if (say_)
    say_(fmt::format("{}, frame {}: rendering a reference of {} samples", scene, frame, samples_per_pixel(params.sampling)));
  Image8 codes = trace(params, frame, samples_per_pixel(params.sampling));
  if (context_.cancelled) return codes;
  std::error_code ignored;  // the writing below says what is wrong
  std::filesystem::create_directories(folder_, ignored);
  write_picture(file, codes);
  ++rendered_;
  return codes;
}

}  // namespace lippmann::bench
