// The Stanford light field archive's folders: out_{row}_{column}_{y}_{x}.png, row 0 at the top, column 0 at the left; y and x
// say where the camera stood, y counted downwards like the rows. (Names in the archive end with or without a further _.)
//
// Without known cameras y and x are the row and the column; they are not read.
#include <fmt/format.h>

#include "core/text_pattern.hpp"
#include "layout/view_files.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

LightField read_stanford(const fs::path& folder, const FormatOptions& options) {
  static const TextPattern name("out_([0-9]{1,5})_([0-9]{1,5})(?:_.*)?\\.(?:png|jpg|exr|ppm|tif|tiff)");
  const std::vector<NumberedFile> files = numbered_files(folder, name, "out_00_00_<y>_<x>.png, ...");
  const ViewGrid grid = complete_grid(folder, files);
  std::vector<fs::path> by_view(files.size());
  for (std::size_t i = 0; i < files.size(); ++i)
    by_view[static_cast<std::size_t>(from_top_left(grid, static_cast<int>(i)))] = files[i].path;
  return read_view_files(by_view, grid, picture_reader(options.warn));
}

std::vector<fs::path> write_stanford(const LightField& field, const fs::path& folder, const FormatOptions&) {
  const char* ending = exact_ending(field.stack);
  return write_view_files(field, folder, [&](int view) {
    const int row = field.grid.rows - 1 - view / field.grid.columns, column = view % field.grid.columns;
    Vec2d eye(column, -row);
    if (field.cameras) eye = field.cameras->eyes_mm[static_cast<std::size_t>(view)];
    return fmt::format("out_{:02}_{:02}_{:.6f}_{:.6f}.{}", row, column, -eye.y + 0.0, eye.x, ending);
  });
}

}  // namespace

LightFieldFormat stanford_format() {
  return {"stanford",    "the Stanford archive's folder: out_{row}_{column}_{y}_{x}.png, from the top left",
          true,          true,
          read_stanford, write_stanford};
}

}  // namespace lippmann
