// The files that a scene file may name: found in the scene's own folder or below an asset root, read within a budget.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "scene/side_file.hpp"

namespace lippmann::tachyon {

class SceneFolder {
 public:
  /// scene_file: the .dat file. asset_root: below which side files may lie besides; empty: nowhere else.
  explicit SceneFolder(const std::filesystem::path& scene_file, const std::filesystem::path& asset_root = {});

  /// A picture that the scene calls `name`, and why it cannot be used.
  SideFile find(std::string_view name, const std::string& where) const;

  /// Where a side file is that the scene calls `name`, relative to the folder. Throws Error at `where` for files that lie
  /// elsewhere. The file need not exist.
  std::filesystem::path resolve(std::string_view name, const std::string& where) const;

  /// The contents of a regular file. Throws Error at `where` if it cannot be read, or when all text read through this object
  /// would exceed 1 GiB: a few lines may include the same file many times.
  std::string read_text(const std::filesystem::path& file, const std::string& where);

 private:
  SideFolders folders_;
  std::size_t budget_bytes_ = std::size_t{1} << 30;
};

}  // namespace lippmann::tachyon
