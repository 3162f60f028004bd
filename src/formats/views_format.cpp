// A folder of view_000.png, view_001.png, ..., or of pictures with arbitrary names. Views are numbered from the lower left as
// in layout/view_layout.hpp. views.json states rows of views, the shape of pixels and cameras (formats/views_side_file.hpp).
#include <fmt/format.h>

#include <algorithm>

#include "core/folder_entries.hpp"
#include "core/text_pattern.hpp"
#include "formats/picture_folder.hpp"
#include "formats/rendered.hpp"
#include "formats/view_files.hpp"
#include "formats/views_side_file.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr const char* kViewNames = "a folder of view_000.png, view_001.png, ...";

/// Reads the depth of all views. If any view has no depth, field.depth stays empty.
void read_depth(const std::vector<fs::path>& by_view, const FormatOptions& options, LightField& field) {
  fs::path without_depth;
  for (int view = 0; view < field.grid.count(); ++view) {
    const fs::path& path = by_view[static_cast<std::size_t>(view)];
    const std::optional<Image> depth = rendered_depth(path);
    if (!depth || Vec2i(depth->width, depth->height) != field.view_size) {
      if (without_depth.empty()) without_depth = path;
      continue;
    }
    if (!field.depth) field.depth = Image(field.view_size.x, field.view_size.y * field.grid.count(), 1);
    set_depth(field, view, *depth);
  }
  if (field.depth && !without_depth.empty())
    leave_out_depth(field, options, without_depth.string() + " has no depth layer of its size");
}

/// Returns view_000.png, ... if such files exist, else all pictures of the folder.
std::vector<fs::path> views_in(const fs::path& folder, const FormatOptions& options) {
  static const TextPattern name("view_([0-9]{1,6})\\.[^.]+", TextPattern::Letters::kEitherCase);
  const std::vector<fs::directory_entry> entries = entries_of(folder, kViewNames);
  if (std::none_of(entries.begin(), entries.end(),
                   [](const fs::directory_entry& entry) { return name.match(entry.path().filename().string()); }))
    return pictures_of_views(folder, options.warn);
  const std::vector<NumberedFile> files = numbered_files(folder, name, kViewNames);
  const int first = files.front().numbers[0];
  require_all_views(folder, files, first > 1 ? 0 : first, files.back().numbers[0],
                    [](int number) { return fmt::format("view_{:03}", number); });
  std::vector<fs::path> by_view;
  for (const NumberedFile& file : files) by_view.push_back(file.path);
  return by_view;
}

LightField read_views(const fs::path& folder, const FormatOptions& options) {
  const std::vector<fs::path> by_view = views_in(folder, options);
  const int count = static_cast<int>(by_view.size());
  const std::optional<ViewsSideFile> side = read_views_side_file(folder);
  if (side && side->grid && side->grid->count() != count)
    throw Error((folder / "views.json").string(),
                fmt::format("states {}x{} views, but the folder has {}", side->grid->columns, side->grid->rows, count),
                "columns and rows of the pictures, or no views.json");
  const ViewGrid grid = options.views.value_or(side && side->grid ? *side->grid : ViewGrid{count, 1});
  if (grid.count() != count)
    throw usage_error("views",
                      fmt::format("{}x{} does not match the {} views in {}", grid.columns, grid.rows, count, folder.string()));
  FormatOptions reading = options;
  if (side && side->pixel_aspect) reading.pixel_aspect = side->pixel_aspect;
  LightField field = read_view_files(by_view, grid, reading);
  if (options.fit_view) return field;  // views that fit_view has resized do not match the cameras and the depth
  if (side) field.positions = side->positions, field.cameras = side->cameras;
  if (options.with_depth) read_depth(by_view, options, field);
  return field;
}

std::vector<fs::path> write_views(const LightField& field, const fs::path& folder, const FormatOptions&) {
  const char* ending = exact_ending(field.stack);
  std::vector<fs::path> written =
      write_view_files(field, folder, [&](int view) { return fmt::format("view_{:03}.{}", view, ending); });
  const double aspect = pixel_aspect(field);
  const bool has_facts = field.grid.rows > 1 || aspect != 1.0 || field.positions || field.cameras;
  if (has_facts || has_views_side_file(folder))
    written.push_back(write_views_side_file(
        folder, {field.grid, aspect != 1.0 ? std::optional(aspect) : std::nullopt, field.positions, field.cameras}));
  return written;
}

}  // namespace

LightFieldFormat views_format() {
  return {.name = "views",
          .description =
              "a folder of view_000.png, ..., or of pictures of one size, 1.jpg ... 10.jpg, in the order of their names; from "
              "left to right, "
              "then upwards; `views`: across and up",
          .is_folder = true,
          .read = read_views,
          .write = write_views,
          .reads = {.views = true}};
}

}  // namespace lippmann
