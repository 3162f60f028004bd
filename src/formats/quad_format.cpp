// Four views in one picture, for Leia's displays. The leftmost view is at the top left. The next views are at the top right,
// bottom left and bottom right. A quilt of 2x2 tiles, by contrast, begins with the lower row.
#include <fmt/format.h>

#include "formats/packed_views.hpp"
#include "formats/quad_name.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr ViewGrid kQuadViews{4, 1}, kQuadTiles{2, 2};
constexpr ViewLayout kQuadAsQuilt{LayoutKind::kQuilt, kQuadViews, kQuadTiles};

LightField with_rows_exchanged(const LightField& field) {
  LightField exchanged = field;
  for (int view = 0; view < kQuadViews.count(); ++view) {
    const int other = view ^ kQuadTiles.columns;
    set_view(exchanged, view, view_of(field, other));
    if (field.depth) set_depth(exchanged, view, depth_of(field, other));
    if (field.alpha) set_alpha(exchanged, view, alpha_of(field, other));
  }
  return exchanged;
}

LightField read_quad(const fs::path& path, const FormatOptions& options) {
  return with_rows_exchanged(read_packed(path, kQuadAsQuilt, options.with_depth, options.warn));
}

std::vector<fs::path> write_quad(const LightField& field, const fs::path& path, const FormatOptions&) {
  if (field.grid != kQuadViews)
    throw usage_error("to",
                      fmt::format("a quad has 4 views from left to right, but the light field has {}x{}", field.grid.columns,
                                  field.grid.rows),
                      "4 views in one row, selected by `keep`, such as 5-41:12 (views 5, 17, 29 and 41)");
  return write_packed(with_rows_exchanged(field), kQuadAsQuilt, with_quad_name(path));
}

}  // namespace

LightFieldFormat quad_format() {
  return {.name = kQuadFormat,
          .description = "four views in one picture, the leftmost at the top left (Leia)",
          .read = read_quad,
          .write = write_quad};
}

}  // namespace lippmann
