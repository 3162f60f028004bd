// Folders with one picture per view: finds the files by name, and reads and writes them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text_pattern.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// A file whose name matches a pattern, and the numbers in the pattern's first 1 or 2 groups.
struct NumberedFile {
  std::vector<int> numbers;
  std::filesystem::path path;
};

/// Returns the files of a folder that match the pattern, in ascending order of their numbers; empty if there are none. Throws
/// Error naming the folder if it cannot be listed or has two files with the same numbers. `accepted`: description of the
/// file names, for the message.
std::vector<NumberedFile> find_numbered_files(const std::filesystem::path& folder, const TextPattern& pattern,
                                              const std::string& accepted);

/// Returns the same as find_numbered_files(), but throws Error naming the folder if there are no such files.
std::vector<NumberedFile> numbered_files(const std::filesystem::path& folder, const TextPattern& pattern,
                                         const std::string& accepted);

/// Returns the grid of files that are numbered by row and column, starting at any number. Throws Error naming the
/// folder and a missing file if the grid is incomplete.
ViewGrid complete_grid(const std::filesystem::path& folder, const std::vector<NumberedFile>& files);

/// Throws Error naming the first missing file unless `files` contains a file for every number from `first` to `last`. Each file
/// has one number. name(number) returns a file name without extension.
void require_all_views(const std::filesystem::path& folder, const std::vector<NumberedFile>& files, int first, int last,
                       const std::function<std::string(int number)>& name);

/// Throws Error naming `where` if the stack of these views would have 2^32 pixels or more, or would exceed `available_bytes` of
/// memory (infinite: no limit).
void require_stack_fits(const std::string& where, int views, Vec2i view_size, std::size_t sample_bytes, double available_bytes);

/// Reads the views with `read`. by_view: one file per view, in order. Throws Error naming a file whose size or sample type
/// differs from that of the first file. If the views do not fit into memory, throws Error naming the first file.
LightField read_view_files(const std::vector<std::filesystem::path>& by_view, ViewGrid grid,
                           const std::function<Picture(const std::filesystem::path&)>& read);
/// Reads the views with read_picture(). Uses options.warn and options.fit_view. `check_size`, if given, is called with the size
/// of each picture before options.fit_view changes the picture.
LightField read_view_files(const std::vector<std::filesystem::path>& by_view, ViewGrid grid, const FormatOptions& options,
                           const std::function<void(int view, Vec2i size)>& check_size = {});

/// Returns the options with the aspect ratio of a camera's pixels. `focal_px`: focal lengths across and down.
FormatOptions with_pixel_aspect(FormatOptions options, Vec2d focal_px);

/// Records that the depth of all views is left out, and warns with the reason, such as "a.pfm is missing".
void leave_out_depth(LightField& field, const FormatOptions& options, const std::string& reason);

/// Returns whether all depth maps exist. If only some exist, calls leave_out_depth() with the first missing file.
bool has_all_depth_maps(const std::vector<std::filesystem::path>& maps, LightField& field, const FormatOptions& options);

/// Returns "png" for integers, "exr" for floats.
const char* exact_ending(const Picture& picture);

/// Creates the folder, writes one file per view with its opacities into it, and returns the files in the order of their names.
/// name(view) returns a file name with extension.
std::vector<std::filesystem::path> write_view_files(const LightField& field, const std::filesystem::path& folder,
                                                    const std::function<std::string(int view)>& name);

}  // namespace lippmann
