// Folders with one picture per view: finds files by name, reads and writes them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text_pattern.hpp"
#include "lippmann/layout/formats.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// A file whose name matches a pattern, with the numbers captured by the pattern's first 1 or 2 groups.
struct NumberedFile {
  std::vector<int> numbers;
  std::filesystem::path path;
};

/// Returns the matching files of a folder in ascending order of their numbers. Throws Error naming the folder if it cannot be
/// listed, has no such files (`accepted` describes their names) or two with the same numbers.
std::vector<NumberedFile> numbered_files(const std::filesystem::path& folder, const TextPattern& pattern,
                                         const std::string& accepted);

/// Returns the grid of files numbered by row and column, which may begin at any number. Throws Error naming the folder and a
/// missing file if there are gaps.
ViewGrid complete_grid(const std::filesystem::path& folder, const std::vector<NumberedFile>& files);

/// Throws Error naming `where` if the stack of these views would have 2^32 pixels or more, or would not fit into the available
/// memory (infinite: no limit).
void require_stack_fits(const std::string& where, int views, Vec2i view_size, std::size_t sample_bytes, double available_bytes);

/// Reads the views in order. by_view: grid.count() files. Throws Error naming the first file whose size or sample type differs
/// from the first one's, or the first file if all of them do not fit into memory.
LightField read_view_files(const std::vector<std::filesystem::path>& by_view, ViewGrid grid,
                           const std::function<Picture(const std::filesystem::path&)>& read);
/// Does the same with read_picture(), the warnings of the options and their fit_view.
LightField read_view_files(const std::vector<std::filesystem::path>& by_view, ViewGrid grid, const FormatOptions& options);

/// Returns the lossless format for the picture's samples: "png" for integers, "exr" for floats.
const char* exact_ending(const Picture& picture);

/// Writes one file per view to the folder, creating it, and returns the files in order of their names. name(view) includes the
/// extension.
std::vector<std::filesystem::path> write_view_files(const LightField& field, const std::filesystem::path& folder,
                                                    const std::function<std::string(int view)>& name);

}  // namespace lippmann
