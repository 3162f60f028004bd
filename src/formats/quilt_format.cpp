// Views side by side in one picture, the format of Looking Glass's programs. The picture's name and its side file
// describe the tiles.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/regular_file.hpp"
#include "formats/packed_views.hpp"
#include "formats/quilt_side_file.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/formats/quilt_name.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// The properties of a quilt. A flag overrides the name and the side file, which must agree.
struct Quilt {
  ViewGrid tiles, grid;
  bool inverted = false;
  std::optional<double> aspect;
};

ViewGrid row_of_views(int views) { return {views, 1}; }

Quilt described(const fs::path& path, const FormatOptions& options) {
  const std::optional<QuiltName> name = parse_quilt_name(path);
  if (options.tiles)
    return {*options.tiles, row_of_views(options.tiles->count()), false, name ? std::optional(name->aspect) : std::nullopt};
  const std::optional<QuiltSideFile> side = read_quilt_side_file(path);
  if (!name && !side) {
    const bool has_side_file = is_regular_file_there(quilt_side_path(path));
    throw usage_error("quilt",
                      "the number of tiles of " + path.string() + " is unknown: neither its name nor " +
                          (has_side_file ? "its side file " + quilt_side_path(path).string() : "a side file") + " states it",
                      "CxR, such as 8x6" +
                          (has_side_file ? ", or a side file such as " + std::string(kQuiltSideFileExample) : std::string()));
  }
  if (name && side && name->tiles != side->quilt.tiles)
    throw Error(path.string(),
                fmt::format("its name states {}x{} tiles, but its side file {}x{}", name->tiles.columns, name->tiles.rows,
                            side->quilt.tiles.columns, side->quilt.tiles.rows),
                "`quilt` with the right number of tiles");
  if (side) return {side->quilt.tiles, side->grid.value_or(row_of_views(side->views)), side->inverted, side->quilt.aspect};
  return {name->tiles, row_of_views(name->tiles.count()), false, name->aspect};
}

void reverse_views(LightField& field) {
  const LightField from = field;
  const int columns = field.grid.columns;
  for (int view = 0; view < field.grid.count(); ++view) {
    const int source = view + columns - 1 - 2 * (view % columns);
    set_view(field, view, view_of(from, source));
    if (field.depth) set_depth(field, view, depth_of(from, source));
    if (field.alpha) set_alpha(field, view, alpha_of(from, source));
  }
}

LightField read_quilt(const fs::path& path, const FormatOptions& options) {
  const Quilt quilt = described(path, options);
  const ViewGrid grid = options.views.value_or(quilt.grid);
  if (grid.count() != quilt.grid.count())
    throw usage_error("views", fmt::format("{}x{} views do not match {}x{} tiles", grid.columns, grid.rows, quilt.tiles.columns,
                                           quilt.tiles.rows));
  LightField field = read_packed(path, {LayoutKind::kQuilt, grid, quilt.tiles}, options.with_depth, options.warn);
  if (quilt.inverted) reverse_views(field);
  field.tiles = quilt.tiles;
  field.aspect = quilt.aspect.value_or(static_cast<double>(field.view_size.x) / field.view_size.y);
  return field;
}

ViewGrid tiles_for(const LightField& field, const FormatOptions& options) {
  const int count = field.grid.count();
  if (options.tiles && options.tiles->count() != count)
    throw usage_error("quilt",
                      fmt::format("{}x{} tiles do not match {} views", options.tiles->columns, options.tiles->rows, count));
  if (options.tiles) return *options.tiles;
  if (field.tiles && field.tiles->count() == count) return *field.tiles;
  return field.grid.rows > 1 ? field.grid : squarest_tiles(count);
}

std::vector<fs::path> write_quilt(const LightField& field, const fs::path& path, const FormatOptions& options) {
  const QuiltName quilt{tiles_for(field, options), options.aspect.value_or(field.aspect)};
  const fs::path named = with_quilt_name(path, quilt);
  std::vector<fs::path> written = write_packed(field, {LayoutKind::kQuilt, field.grid, quilt.tiles}, named);
  write_quilt_side_file(named, {quilt, field.grid.count(), false, field.grid});
  written.push_back(quilt_side_path(named));
  return written;
}

}  // namespace

LightFieldFormat quilt_format() {
  return {.name = "quilt",
          .description = "views side by side, the first at the bottom left (Looking Glass); `quilt`: tiles",
          .read = read_quilt,
          .write = write_quilt,
          .reads = {.views = true, .tiles = true},
          .writes = {.tiles = true, .aspect = true}};
}

}  // namespace lippmann
