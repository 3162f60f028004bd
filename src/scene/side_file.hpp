// Finds the files beside a scene file that it refers to: in the scene's own folder, below an asset root, and nowhere else.
//
// Names are relative to the scene's folder. They are judged before links are followed, so that what is refused does not depend
// on the disk, and again after, so that no link leads out.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lippmann {

struct SideFolders {
  std::filesystem::path folder{};      ///< the folder of the scene's file; empty: the current one
  std::filesystem::path asset_root{};  ///< files may lie below it as well; empty: none
};

/// A file that a scene names.
struct SideFile {
  std::filesystem::path path{};  ///< where it is, if it may be opened
  std::string problem{};         ///< why it may not: lies elsewhere or does not exist; empty: it may
};

/// Looks for a regular file that a scene calls `name`. Throws Error at `where` only where the scene's folder cannot be read.
SideFile find_side_file(const SideFolders& folders, std::string_view name, const std::string& where);

/// Where a file is that a scene calls `name`; it need not exist. Throws Error at `where` for one that lies elsewhere.
std::filesystem::path side_file(const SideFolders& folders, std::string_view name, const std::string& where);

}  // namespace lippmann
