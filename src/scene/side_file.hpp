// Finds the files that a scene file refers to. They must lie in the scene's folder or below an asset root.
//
// Names are relative to the scene's folder. They are checked twice: before links are resolved, so that the rejection of a name
// does not depend on the disk, and afterwards, so that no link leads outside.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lippmann {

struct SideFolders {
  std::filesystem::path folder{};      ///< folder of the scene file; empty: the current folder
  std::filesystem::path asset_root{};  ///< another folder that may contain files; empty: none
};

/// A file that a scene refers to.
struct SideFile {
  std::filesystem::path path{};  ///< location of the file, if it may be opened
  std::string problem{};         ///< why the file may not be opened (outside the folders, or missing); empty: it may be opened
};

/// Looks for a regular file that a scene refers to as `name`. Throws Error at `where` only if the scene's folder cannot be
/// read.
SideFile find_side_file(const SideFolders& folders, std::string_view name, const std::string& where);

/// Returns the location of a file that a scene refers to as `name`; it need not exist. Throws Error at `where` if the location
/// is outside `folders`.
std::filesystem::path side_file(const SideFolders& folders, std::string_view name, const std::string& where);

}  // namespace lippmann
