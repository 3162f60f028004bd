// Folders of pictures with arbitrary names, where each picture is a view, in natural order of their names: 2.jpg before 10.jpg.
//
// Subfolders are not searched. All functions throw Error naming the folder if it cannot be listed.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace lippmann {

/// Returns whether a folder can be treated as views by default: it holds at least two pictures and otherwise only subfolders,
/// notes (.txt, .md, .pdf, .xmp) and files of file managers (Thumbs.db, desktop.ini, hidden files). Opens no file.
bool is_picture_folder(const std::filesystem::path& folder);

/// Returns the pictures of a folder, ignoring other files; one call of `warn` lists those. Reads the pictures' headers only.
/// Throws Error if there are fewer than two, if they differ in size or sample type (listing the differences), or if two names
/// differ only in their extension.
std::vector<std::filesystem::path> pictures_of_views(const std::filesystem::path& folder,
                                                     const std::function<void(std::string_view)>& warn = {});

}  // namespace lippmann
