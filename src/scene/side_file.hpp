// Finds the files that a scene file refers to. Such a file must lie in the scene's folder or below the asset root.
//
// File names are relative to the folder of the scene. Each name is checked twice: before symbolic links are resolved, so that
// the result does not depend on the disk, and afterwards, so that no link leads outside.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lippmann {

struct SideFolders {
  std::filesystem::path folder{};
  std::filesystem::path asset_root{};
};

struct SideFile {
  std::filesystem::path path{};
  std::string problem{};  ///< why the file may not be opened; empty: no problem
};

/// Looks for the regular file that a scene refers to as `name`. Throws Error at `where` only if the scene's folder cannot be
/// read.
SideFile find_side_file(const SideFolders& folders, std::string_view name, const std::string& where);

/// Returns the location of the file that a scene refers to as `name`. The file need not exist. Throws Error at `where` if the
/// location is outside `folders`.
std::filesystem::path side_file(const SideFolders& folders, std::string_view name, const std::string& where);

}  // namespace lippmann
