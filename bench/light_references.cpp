#include "bench/light_references.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <utility>

#include "bench/bench.hpp"
#include "core/fingerprint.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/image/picture_file.hpp"
#include "lippmann/layout/film_views.hpp"

namespace lippmann::bench {
namespace {

namespace fs = std::filesystem;

/// Returns nullopt if the file is missing, damaged or of another size than `like`.
std::optional<Image8> read_kept(const fs::path& file, const Image8& like) {
  if (!fs::exists(file)) return std::nullopt;
  try {
    Picture picture = read_picture(file);
    auto* codes = std::get_if<Image8>(&picture);
    if (codes && codes->width == like.width && codes->height == like.height) return std::move(*codes);
  } catch (const Error&) {
  }
  return std::nullopt;
}

}  // namespace

fs::path reference_folder(const std::string& requested) {
  if (!requested.empty()) return requested;
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache) return fs::path(cache) / "lippmann" / "references";
  if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache" / "lippmann" / "references";
  throw usage_error("--references", "neither XDG_CACHE_HOME nor HOME is set", "a folder");
}

LightReferences::LightReferences(Stage& stage, Sampling sampling, fs::path folder, const ThreadPool& pool,
                                 const Context& context, std::function<void(std::string_view)> say)
    : stage_(stage),
      sampling_(std::move(sampling)),
      folder_(std::move(folder)),
      pool_(pool),
      context_(context),
      say_(std::move(say)) {}

/// Sets `fingerprint` to a hash of the film's bits, which depend on the scene, the optics and the program.
Image8 LightReferences::render(int frame, std::uint32_t seed, int spp, std::uint64_t* fingerprint) {
  Sampling sampling = sampling_;
  sampling.seed = seed, sampling.spp = spp, sampling.denoise = Denoise::kNone;
  const Image film = render_frame(stage_, sampling, frame, pool_, context_).pictures.film;
  if (context_.cancelled) throw interrupted();
  if (fingerprint) {
    Fingerprint print;
    print.add_bytes(film.data.data(), film.data.size() * sizeof(float));
    print.add(samples_per_pixel(sampling_));
    print.add(stage_.scene.encoding);
    *fingerprint = print.value();
  }
  return to_codes(views_of_layer(film, stage_.placed.optics), stage_.scene.encoding);
}

Image8 LightReferences::half(const std::string& name, int frame, std::uint32_t seed) {
  std::uint64_t fingerprint = 0;
  const Image8 probe = render(frame, seed, 1, &fingerprint);
  const auto file = folder_ / fmt::format("{}_{:04}_{:016x}.png", name, frame, fingerprint);
  if (std::optional<Image8> codes = read_kept(file, probe)) {
    ++kept_;
    return std::move(*codes);
  }
  const int spp = std::max(1, samples_per_pixel(sampling_) / 2);
  if (say_) say_(fmt::format("{}, frame {}: rendering a reference of {} samples", name, frame, spp));
  Image8 codes = render(frame, seed, spp);
  std::error_code ignored;
  fs::create_directories(folder_, ignored);
  write_picture(file, codes);
  ++rendered_;
  return codes;
}

Reference LightReferences::frame(const std::string& name, int frame) {
  return {half(name, frame, sampling_.seed), half(name, frame, sampling_.seed + 1)};
}

}  // namespace lippmann::bench
