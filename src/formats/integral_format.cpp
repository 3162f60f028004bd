// `integral` is the picture behind a lens array. `eslf`, for plenoptic cameras, is the same picture with the pixels
// below each lens rotated by 180 degrees. The pixels of its views are square unless the side file states another shape: a
// plenoptic camera's lenses are round, however many views there are across and up.
#include <fmt/format.h>

#include "formats/eslf_side_file.hpp"
#include "formats/packed_views.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

ViewGrid wanted_views(const fs::path& path, const FormatOptions& options) {
  if (options.views) return *options.views;
  throw usage_error("views", "the number of pixels below each lens of " + path.string() + " is unknown", "CxR, such as 8x1");
}

LightField read_integral(const fs::path& path, const FormatOptions& options) {
  return read_packed(path, {LayoutKind::kIntegral, wanted_views(path, options), {}}, options.with_depth, options.warn);
}

std::vector<fs::path> write_integral(const LightField& field, const fs::path& path, const FormatOptions&) {
  return write_packed(field, {LayoutKind::kIntegral, field.grid, {}}, path);
}

LightField read_eslf(const fs::path& path, const FormatOptions& options) {
  const std::optional<EslfSideFile> side = read_eslf_side_file(path);
  const ViewGrid grid = side && !options.views ? side->grid : wanted_views(path, options);
  if (side && grid != side->grid)
    throw Error(path.string(),
                fmt::format("its side file states {}x{} views, unlike `views`", side->grid.columns, side->grid.rows),
                "the same number in `views`, or no `views`");
  LightField field = read_packed(path, {LayoutKind::kEslf, grid, {}}, options.with_depth, options.warn);
  field.aspect = (side ? side->pixel_aspect : 1.0) * field.view_size.x / field.view_size.y;
  if (side) field.positions = side->positions, field.cameras = side->cameras;
  return field;
}

std::vector<fs::path> write_eslf(const LightField& field, const fs::path& path, const FormatOptions&) {
  std::vector<fs::path> written = write_packed(field, {LayoutKind::kEslf, field.grid, {}}, path);
  written.push_back(write_eslf_side_file(path, {field.grid, pixel_aspect(field), field.positions, field.cameras}));
  return written;
}

}  // namespace

LightFieldFormat integral_format() {
  return {.name = "integral",
          .description = "the picture behind a lens array; `views`: pixels below each lens",
          .read = read_integral,
          .write = write_integral,
          .reads = {.views = true}};
}

LightFieldFormat eslf_format() {
  return {
      .name = "eslf",
      .description = "plenoptic camera: view (u, v) from the top left is every N-th pixel from (u, v); `views` such as 14x14",
      .read = read_eslf,
      .write = write_eslf,
      .reads = {.views = true}};
}

}  // namespace lippmann
