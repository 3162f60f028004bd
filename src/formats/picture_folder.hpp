// Folders of pictures with arbitrary names. Each picture is a view, in the natural order of the names: 2.jpg before
// 10.jpg. Subfolders are not searched. All functions throw Error naming the folder if it cannot be listed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace lippmann {

/// Returns whether a folder is treated as views by default. It must hold at least two pictures and otherwise only
/// subfolders, notes (.txt, .md, .pdf, .xmp) and files of file managers (Thumbs.db, desktop.ini, hidden files). Opens
/// no file.
bool is_picture_folder(const std::filesystem::path& folder);

/// Returns the pictures of a folder. Other files are ignored; one call of `warn` lists them. Reads only the pictures'
/// headers. Throws Error if there are fewer than two pictures, if they differ in size or sample type, or if two names
/// differ only in their extension.
std::vector<std::filesystem::path> pictures_of_views(const std::filesystem::path& folder,
                                                     const std::function<void(std::string_view)>& warn = {});

/// Returns, for example, "a, b, c, d, e and 4 more".
std::string listed_names(const std::vector<std::string>& names);

/// Warns about the pictures of a folder for which has_camera(path) is false. `file`: name of the file that lacks their cameras.
/// Returns whether there are such pictures.
bool warn_of_pictures_without_camera(const std::filesystem::path& folder,
                                     const std::function<bool(const std::filesystem::path&)>& has_camera, std::string_view file,
                                     const std::function<void(std::string_view)>& warn);

}  // namespace lippmann
