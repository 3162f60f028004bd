// The views of a left and a right eye in one picture (layout/stereo.hpp). The picture's name, or the option `stereo`,
// states the packing.
#include <fmt/format.h>

#include <cmath>

#include "image/resample.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

StereoLayout described_stereo(const fs::path& path, const FormatOptions& options) {
  if (options.stereo) return *options.stereo;
  if (const std::optional<StereoLayout> named = parse_stereo_name(path)) return *named;
  throw usage_error("stereo", "the packing of the two views in " + path.string() + " is unknown",
                    fmt::format("{}, {}, {}, {} or {}", kStereoPackingNames[0], kStereoPackingNames[1], kStereoPackingNames[2],
                                kStereoPackingNames[3], kStereoPackingNames[4]));
}

/// Reads both views as they are stored: squeezed views stay squeezed, and row-interlaced views have half the rows.
LightField read_stereo(const fs::path& path, const FormatOptions& options) {
  const StereoLayout layout = described_stereo(path, options);
  const Picture picture = read_picture(path, options.warn);
  const Vec2i stored = stored_view_size(layout.packing, size_of(picture), path.string());
  const Vec2i whole = stored * stereo_squeeze(layout.packing);
  LightField field;
  field.grid = {2, 1};
  field.view_size = layout.packing == StereoPacking::kRows ? Vec2i(stored.x, stored.y / 2) : stored;
  field.aspect = static_cast<double>(whole.x) / whole.y;
  field.stack = blank(picture, stack_size(field));
  move_pixels(picture, pixels_of_stereo(layout, stored), field.stack, {});
  return field;
}

/// Size of a whole view with square pixels that keeps all samples of the field's views.
Vec2i whole_view_size(const LightField& field) {
  const Vec2i size = field.view_size;
  const double wider = field.aspect * size.y / size.x;
  if (std::abs(wider - 1.0) < 0.5 / std::max(size.x, size.y)) return size;
  if (wider > 1.0) return {static_cast<int>(std::lround(size.x * wider)), size.y};
  return {size.x, static_cast<int>(std::lround(size.y / wider))};
}

/// Returns the size of a view as stored: the size of the whole view, squeezed. Halved sides are rounded up. In row-interlaced
/// pictures, the number of rows is rounded up to an even number.
Vec2i stored_size_of(const LightField& field, StereoPacking packing) {
  const Vec2i squeeze = stereo_squeeze(packing), whole = whole_view_size(field);
  const Vec2i stored = (whole + squeeze - 1) / squeeze;
  return packing == StereoPacking::kRows ? Vec2i(stored.x, stored.y + stored.y % 2) : stored;
}

/// Returns the stack of views with size `stored`. Resamples the views in linear light if they have another size.
Picture stored_views(const LightField& field, Vec2i stored) {
  if (stored == field.view_size) return field.stack;
  LightField sized = field;
  sized.view_size = stored;
  sized.stack = blank(field.stack, stack_size(sized));
  for (int eye = 0; eye < 2; ++eye)
    set_view(sized, eye, with_samples_like(field.stack, resampled(to_linear(view_of(field, eye)), stored)));
  return sized.stack;
}

std::vector<fs::path> write_stereo(const LightField& field, const fs::path& path, const FormatOptions& options) {
  if (field.grid != ViewGrid{2, 1})
    throw usage_error("to",
                      fmt::format("a stereo picture has the views of two eyes, but the light field has {}x{}",
                                  field.grid.columns, field.grid.rows),
                      "2 views side by side, selected by `keep`");
  const StereoLayout layout = options.stereo.value_or(StereoLayout{});
  const Vec2i stored = stored_size_of(field, layout.packing);
  Picture picture = blank(field.stack, stereo_picture_size(layout.packing, stored));
  move_pixels(stored_views(field, stored), stereo_pixels(layout, stored), picture, {});
  const fs::path named = with_stereo_name(path, layout);
  write_picture(named, picture);
  return {named};
}

}  // namespace

LightFieldFormat stereo_format() {
  return {.name = "stereo",
          .description = "the views of two eyes in one picture; `stereo`: side by side, over and under, rows",
          .read = read_stereo,
          .write = write_stereo,
          .reads = {.stereo = true},
          .writes = {.stereo = true}};
}

}  // namespace lippmann
