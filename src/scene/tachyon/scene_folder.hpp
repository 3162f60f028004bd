// The side files of a scene: located in the scene's folder or below an asset root, and read within a memory limit.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "scene/side_file.hpp"

namespace lippmann::tachyon {

class SceneFolder {
 public:
  /// scene_file: the .dat file. asset_root: another folder that may contain side files; empty: none.
  explicit SceneFolder(const std::filesystem::path& scene_file, const std::filesystem::path& asset_root = {});

  /// Looks for an image that the scene refers to as `name`. The result states why the image cannot be used, if so.
  SideFile find(std::string_view name, const std::string& where) const;

  /// Returns the path of a side file that the scene refers to as `name`, relative to the scene's folder. The file need not
  /// exist. Throws Error at `where` if the path lies outside both the scene's folder and the asset root.
  std::filesystem::path resolve(std::string_view name, const std::string& where) const;

  /// Returns the contents of a regular file. Throws Error at `where` if it cannot be read, or if the total text read through
  /// this object would exceed 1 GiB, since a few lines may include the same file many times.
  std::string read_text(const std::filesystem::path& file, const std::string& where);

 private:
  SideFolders folders_;
  std::size_t budget_bytes_ = std::size_t{1} << 30;
};

}  // namespace lippmann::tachyon
