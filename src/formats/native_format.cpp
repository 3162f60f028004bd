// The format `native`: the picture on a display's calibrated slanted panel, interlaced from views.
#include <fmt/format.h>

#include <thread>

#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/layout/interlace.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

ThreadPool all_threads() { return ThreadPool(std::max(1, static_cast<int>(std::thread::hardware_concurrency()))); }

const Display& wanted_display(const FormatOptions& options) {
  if (options.display) return *options.display;
  throw usage_error("display", "the display is unknown, but a native frame depends on it",
                    "a name that 'lippmann displays' lists, or a file");
}

/// Reads as many views as the options state, or as the display's quilt has. Views have the size of the quilt's tiles.
LightField read_native(const fs::path& path, const FormatOptions& options) {
  const Display& display = wanted_display(options);
  const DisplayQuilt quilt = display.quilt.value_or(DisplayQuilt{});
  const int count = options.views ? options.views->count() : quilt.columns * quilt.rows;
  const Vec2i size(quilt.width / quilt.columns, quilt.height / quilt.rows);
  constexpr std::int64_t kMaxSamples = std::int64_t{1} << 31;
  if (options.views && options.views->rows != 1) throw usage_error("views", "a panel has only one row of views", "Nx1");
  if (std::int64_t{3} * count * size.x * size.y > kMaxSamples)
    throw usage_error("views", fmt::format("{} views of {}x{} pixels are too many", count, size.x, size.y), "fewer views");
  LightField field = deinterlace(read_picture(path, options.warn), display, count, size, path.string(), all_threads());
  if (count == quilt.columns * quilt.rows) field.tiles = ViewGrid{quilt.columns, quilt.rows}, field.aspect = quilt.aspect;
  return field;
}

std::vector<fs::path> write_native(const LightField& field, const fs::path& path, const FormatOptions& options) {
  const InterlaceParams params{options.filter.value_or(ViewFilter::kNearest), options.sigma_views.value_or(0.5)};
  const Display& display = wanted_display(options);
  write_picture(path, interlace(field, display, params, all_threads()), display.dpi);
  return {path};
}

}  // namespace

LightFieldFormat native_format() {
  return {.name = "native",
          .description = "the frame of a slanted panel, one view per sub-pixel; `display`: the panel",
          .read = read_native,
          .write = write_native,
          .reads = {.views = true, .display = true},
          .writes = {.display = true, .filter = true}};
}

}  // namespace lippmann
