// The 4D light field benchmark's folders: input_Cam000.png ... row by row from the top left, and parameters.cfg.
//
// Honauer, Johannsen, Kondermann, Goldluecke: A dataset and evaluation methodology for depth estimation on 4D light fields,
// ACCV 2016.
#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "layout/formats.hpp"
#include "layout/view_files.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// As said, or a square.
ViewGrid grid_of(const fs::path& folder, int count, const FormatOptions& options) {
  const int side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(count))));
  if (!options.views && side * side != count)
    throw usage_error("--views", fmt::format("{} has {} views, which are no square", folder.string(), count),
                      "CxR, such as 9x1");
  const ViewGrid grid = options.views.value_or(ViewGrid{side, side});
  if (grid.count() != count)
    throw usage_error(
        "--views", fmt::format("{}x{} are not as many as the {} views in {}", grid.columns, grid.rows, count, folder.string()));
  return grid;
}

LightField read(const fs::path& folder, const FormatOptions& options) {
  static const std::regex name("input_Cam([0-9]{1,6})\\.[^.]+");
  const std::vector<NumberedFile> files = numbered_files(folder, name, "input_Cam000.png, input_Cam001.png, ...");
  const int count = static_cast<int>(files.size());
  if (files.front().numbers[0] != 0 || files.back().numbers[0] != count - 1)
    throw Error(folder.string(), "views are missing", fmt::format("all from 0 to {}", files.back().numbers[0]));
  const ViewGrid grid = grid_of(folder, count, options);
  std::vector<fs::path> by_view(files.size());
  for (int i = 0; i < count; ++i)
    by_view[static_cast<std::size_t>(from_top_left(grid, i))] = files[static_cast<std::size_t>(i)].path;
  return read_view_files(by_view, grid);
}

std::vector<fs::path> write(const LightField& field, const fs::path& folder, const FormatOptions&) {
  const char* ending = exact_ending(field.stack);
  return write_view_files(field, folder,
                          [&](int view) { return fmt::format("input_Cam{:03}.{}", from_top_left(field.grid, view), ending); });
}

}  // namespace

LightFieldFormat hci_format() {
  return {"hci", "the 4D light field benchmark's folder: input_Cam000.png, ..., from the top left", true, true, read, write};
}

}  // namespace lippmann
