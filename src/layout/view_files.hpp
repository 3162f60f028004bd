// Folders that hold a picture for each view: finding them by their names, reading and writing them.
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

/// The files of a folder whose names match, by the numbers that the pattern's first groups capture (1 or 2 of them), ascending.
struct NumberedFile {
  std::vector<int> numbers;
  std::filesystem::path path;
};

/// Throws Error naming the folder if it cannot be listed, has no such files (`accepted` says what they are called) or two with
/// the same numbers.
std::vector<NumberedFile> numbered_files(const std::filesystem::path& folder, const TextPattern& pattern,
                                         const std::string& accepted);

/// For files with rows and columns, which may begin at any number: how many there are, if none is missing between the first
/// and the last. Throws Error naming the folder and one that is missing.
ViewGrid complete_grid(const std::filesystem::path& folder, const std::vector<NumberedFile>& files);

/// Throws Error naming `where` if the stack of that many views would have 2^32 pixels or more, or would not fit into the
/// memory that is available (infinite: any amount).
void require_stack_fits(const std::string& where, int views, Vec2i view_size, std::size_t sample_bytes, double available_bytes);

/// Throws Error naming the first file whose size or kind of samples is not that of the first, or the first if all
/// of them do not fit into memory. by_view: grid.count() of them.
LightField read_view_files(const std::vector<std::filesystem::path>& by_view, ViewGrid grid,
                           const std::function<Picture(const std::filesystem::path&)>& read);
/// The same by read_picture, with the warnings of the options and their fit_view.
LightField read_view_files(const std::vector<std::filesystem::path>& by_view, ViewGrid grid, const FormatOptions& options);

/// PNG for codes, EXR for floats: "png" or "exr".
const char* exact_ending(const Picture& picture);

/// One file per view into the folder, which is made. name(view), with its ending. In the order of names.
std::vector<std::filesystem::path> write_view_files(const LightField& field, const std::filesystem::path& folder,
                                                    const std::function<std::string(int view)>& name);

}  // namespace lippmann
