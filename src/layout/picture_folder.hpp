// Folders of pictures with names of any kind, each of which is a view, in the natural order of their names: 2.jpg
// before 10.jpg.
//
// Subfolders are not searched. All functions throw Error naming the folder if it cannot be listed.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace lippmann {

/// Whether a folder can be taken for views without being told so: it holds two or more pictures and, beside them, only
/// subfolders, notes (.txt, .md, .pdf, .xmp) and what file managers leave (Thumbs.db, desktop.ini, hidden files). Opens
/// no file.
bool is_picture_folder(const std::filesystem::path& folder);

/// The pictures of a folder, whatever else it holds; one call of `warn` names what is left out. Reads their headers, decodes
/// none. Throws Error if there are fewer than two, if they differ in size or kind of samples (the message lists those that do),
/// or if two have the same name but for the ending.
std::vector<std::filesystem::path> pictures_of_views(const std::filesystem::path& folder,
                                                     const std::function<void(std::string_view)>& warn = {});

}  // namespace lippmann
