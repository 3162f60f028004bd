// Folders of decoded views of plenoptic cameras: PREFIX{row}_{column}.png from the top left. Toolboxes for Lytro cameras write
// such names, and data sets (EPFL, INRIA) use them: SAI_07_07.png, lf_1_1.png, Bee_2_07_07.png. All files have the same prefix.
// The first row and column may have any number.
#include <fmt/format.h>

#include "core/folder_entries.hpp"
#include "core/text_pattern.hpp"
#include "formats/view_files.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

void require_one_prefix(const fs::path& folder) {
  static const TextPattern name("((?:.{0,200}[^0-9])?)[0-9]{1,4}_[0-9]{1,4}\\.(?:ppm|png|tiff?|bmp|jpe?g|webp|exr)",
                                TextPattern::Letters::kEitherCase);
  std::optional<std::string> prefix;
  for (const fs::directory_entry& entry : entries_of(folder, "a folder of views")) {
    const std::optional<PatternMatch> found = name.match(entry.path().filename().string());
    if (!found) continue;
    if (!prefix) prefix = found->groups[1];
    if (found->groups[1] != *prefix)
      throw Error(folder.string(), fmt::format("the names of its views begin with {} and with {}", *prefix, found->groups[1]),
                  "one prefix, such as SAI_00_00.png, SAI_00_01.png, ...");
  }
}

LightField read_lytro(const fs::path& folder, const FormatOptions& options) {
  static const TextPattern name("(?:.{0,200}[^0-9])?([0-9]{1,4})_([0-9]{1,4})\\.(?:ppm|png|tiff?|bmp|jpe?g|webp|exr)",
                                TextPattern::Letters::kEitherCase);
  require_one_prefix(folder);
  const std::vector<NumberedFile> files = numbered_files(folder, name, "SAI_00_00.png, SAI_00_01.png, ...");
  const ViewGrid grid = complete_grid(folder, files);
  std::vector<fs::path> by_view(files.size());
  for (std::size_t i = 0; i < files.size(); ++i)
    by_view[static_cast<std::size_t>(from_top_left(grid, static_cast<int>(i)))] = files[i].path;
  return read_view_files(by_view, grid, options);
}

std::vector<fs::path> write_lytro(const LightField& field, const fs::path& folder, const FormatOptions&) {
  const char* ending = exact_ending(field.stack);
  return write_view_files(field, folder, [&](int view) {
    return fmt::format("SAI_{:02}_{:02}.{}", field.grid.rows - 1 - view / field.grid.columns, view % field.grid.columns,
                       ending);
  });
}

}  // namespace

LightFieldFormat lytro_format() {
  return {.name = "lytro",
          .description =
              "decoded views of a plenoptic camera (EPFL, INRIA): SAI_{row}_{column}.png or any one prefix, from the top left",
          .is_folder = true,
          .read = read_lytro,
          .write = write_lytro};
}

}  // namespace lippmann
