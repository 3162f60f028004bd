#include "formats/view_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <set>

#include "core/folder.hpp"
#include "core/folder_entries.hpp"
#include "core/platform.hpp"
#include "core/regular_file.hpp"
#include "formats/picture_alpha.hpp"
#include "image/read_image.hpp"
#include "layout/picture_samples.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace fs = std::filesystem;

namespace {

std::size_t sample_bytes(const Picture& picture) {
  return std::visit([](const auto& image) { return sizeof samples_of(image)[0]; }, picture);
}

}  // namespace

std::vector<NumberedFile> find_numbered_files(const fs::path& folder, const TextPattern& pattern, const std::string& accepted) {
  std::vector<NumberedFile> files;
  for (const fs::directory_entry& entry : entries_of(folder, "a folder of " + accepted)) {
    const std::optional<PatternMatch> found = pattern.match(entry.path().filename().string());
    if (!found) continue;
    NumberedFile file{{}, entry.path()};
    for (std::size_t group = 1; group < found->groups.size(); ++group) {
      const std::string& digits = found->groups[group];
      int number = -1;
      std::from_chars(digits.data(), digits.data() + digits.size(), number);
      file.numbers.push_back(number);
    }
    files.push_back(std::move(file));
  }
  std::sort(files.begin(), files.end(), [](const NumberedFile& a, const NumberedFile& b) {
    return std::tie(a.numbers, a.path) < std::tie(b.numbers, b.path);
  });
  for (std::size_t i = 1; i < files.size(); ++i)
    if (files[i].numbers == files[i - 1].numbers)
      throw Error(folder.string(), fmt::format("has two pictures for view {}: {} and {}", files[i].numbers.front(),
                                               files[i - 1].path.filename().string(), files[i].path.filename().string()));
  return files;
}

std::vector<NumberedFile> numbered_files(const fs::path& folder, const TextPattern& pattern, const std::string& accepted) {
  std::vector<NumberedFile> files = find_numbered_files(folder, pattern, accepted);
  if (files.empty()) throw Error(folder.string(), "contains no views", accepted);
  return files;
}

ViewGrid complete_grid(const fs::path& folder, const std::vector<NumberedFile>& files) {
  std::set<int> rows, columns;
  std::set<std::vector<int>> found;
  for (const NumberedFile& file : files) {
    rows.insert(file.numbers[0]), columns.insert(file.numbers[1]);
    found.insert(file.numbers);
  }
  const int first_row = *rows.begin(), first_column = *columns.begin(), last_row = *rows.rbegin(),
            last_column = *columns.rbegin();
  for (int row = first_row; row <= last_row; ++row)
    for (int column = first_column; column <= last_column; ++column)
      if (!found.contains({row, column}))
        throw Error(folder.string(), fmt::format("the view of row {}, column {} is missing", row, column),
                    fmt::format("all of rows {} to {}, columns {} to {}", first_row, last_row, first_column, last_column));
  return {last_column - first_column + 1, last_row - first_row + 1};
}

void require_all_views(const fs::path& folder, const std::vector<NumberedFile>& files, int first, int last,
                       const std::function<std::string(int number)>& name) {
  int missing = first;
  for (const NumberedFile& file : files) missing += file.numbers[0] == missing ? 1 : 0;
  if (missing > last) return;
  const std::string ending = files.front().path.extension().string();
  const int more = last - first - static_cast<int>(files.size());
  throw Error(folder.string(),
              fmt::format("{}{} is missing{}", name(missing), ending,
                          more > 0 ? fmt::format(", and {} more of {} views", more, last - first + 1) : ""),
              fmt::format("all views from {0}{2} to {1}{2}", name(first), name(last), ending));
}

void require_stack_fits(const std::string& where, int views, Vec2i view_size, std::size_t sample_bytes,
                        double available_bytes) {
  constexpr double kMostPixels = 4294967295.0;  // pixels of a stack have 32-bit indices
  constexpr double kGiB = 1024.0 * 1024.0 * 1024.0;
  const double pixels = 1.0 * views * view_size.x * view_size.y, bytes = 3.0 * pixels * static_cast<double>(sample_bytes);
  const std::string what = fmt::format("{} views of {}x{} pixels", views, view_size.x, view_size.y);
  if (pixels > kMostPixels)
    throw Error(where, what + " are too many", fmt::format("at most {:.0f} pixels in all views", kMostPixels));
  if (bytes > available_bytes)
    throw Error(
        where,
        fmt::format("{} need {:.1f} GiB of memory, but {:.1f} GiB are available", what, bytes / kGiB, available_bytes / kGiB),
        "fewer or smaller pictures");
}

namespace {

using ViewReader = std::function<Picture(const fs::path&, int view)>;

/// `with_alpha`: reads the opacities, too.
LightField read_each_view(const std::vector<fs::path>& by_view, ViewGrid grid, bool with_alpha, const ViewReader& read) {
  LightField field;
  field.grid = grid;
  for (int view = 0; view < grid.count(); ++view) {
    const fs::path& path = by_view[static_cast<std::size_t>(view)];
    const Picture picture = read(path, view);
    if (view == 0) {
      field.view_size = size_of(picture);
      field.aspect = static_cast<double>(field.view_size.x) / field.view_size.y;
      require_stack_fits(path.parent_path().string(), grid.count(), field.view_size, sample_bytes(picture),
                         platform::available_memory_bytes());
      field.stack = blank(picture, stack_size(field));
    }
    if (size_of(picture) != field.view_size || picture.index() != field.stack.index())
      throw Error(path.string(), "differs from the other views in size or sample type",
                  fmt::format("{}x{} pixels of the sample type of {}", field.view_size.x, field.view_size.y,
                              by_view.front().filename().string()));
    set_view(field, view, picture);
    if (!with_alpha) continue;
    if (const std::optional<Image> alpha = read_alpha(path)) set_alpha(field, view, *alpha);
  }
  return field;
}

}  // namespace

LightField read_view_files(const std::vector<fs::path>& by_view, ViewGrid grid,
                           const std::function<Picture(const fs::path&)>& read) {
  return read_each_view(by_view, grid, true, [&](const fs::path& path, int) { return read(path); });
}

LightField read_view_files(const std::vector<fs::path>& by_view, ViewGrid grid, const FormatOptions& options,
                           const std::function<void(int view, Vec2i size)>& check_size) {
  const double pixel = options.pixel_aspect.value_or(1.0);  // width / height
  LightField field = read_each_view(by_view, grid, !options.fit_view, [&](const fs::path& path, int view) {
    Picture picture = read_picture(path, options.warn);
    const Vec2i size = size_of(picture);
    if (check_size) check_size(view, size);
    return options.fit_view ? options.fit_view(std::move(picture), pixel * size.x / size.y, view, grid) : picture;
  });
  field.aspect *= pixel;
  return field;
}

FormatOptions with_pixel_aspect(FormatOptions options, Vec2d focal_px) {
  options.pixel_aspect = focal_px.y / focal_px.x;
  return options;
}

void leave_out_depth(LightField& field, const FormatOptions& options, const std::string& reason) {
  field.depth.reset();
  field.lacks_some_depth = true;
  if (options.warn) options.warn(reason + ", so the depth of all views is left out");
}

bool has_all_depth_maps(const std::vector<fs::path>& maps, LightField& field, const FormatOptions& options) {
  std::vector<fs::path> missing;
  std::copy_if(maps.begin(), maps.end(), std::back_inserter(missing),
               [](const fs::path& map) { return !is_regular_file_there(map); });
  if (missing.empty() || missing.size() == maps.size()) return missing.empty();
  leave_out_depth(field, options,
                  missing.size() == 1 ? fmt::format("{} is missing", missing[0].string())
                                      : fmt::format("{} and {} more of {} depth maps are missing", missing[0].string(),
                                                    missing.size() - 1, maps.size()));
  return false;
}

const char* exact_ending(const Picture& picture) { return std::holds_alternative<Image>(picture) ? "exr" : "png"; }

std::vector<fs::path> write_view_files(const LightField& field, const fs::path& folder,
                                       const std::function<std::string(int view)>& name) {
  make_folder(folder);
  std::vector<fs::path> written;
  for (int view = 0; view < field.grid.count(); ++view) {
    written.push_back(folder / name(view));
    const std::optional<Image> alpha = field.alpha ? std::optional(alpha_of(field, view)) : std::nullopt;
    write_picture(written.back(), view_of(field, view), alpha ? &*alpha : nullptr);
  }
  std::sort(written.begin(), written.end());
  return written;
}

}  // namespace lippmann
