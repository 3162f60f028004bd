// Finds and reads the files that a Tachyon scene refers to. They must lie in the scene's folder or below the asset root.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "scene/side_file.hpp"

namespace lippmann::tachyon {

class SceneFolder {
 public:
  explicit SceneFolder(const std::filesystem::path& scene_file, const std::filesystem::path& asset_root = {});

  /// Looks for an image that the scene refers to as `name`. If the image cannot be used, the result states the reason.
  SideFile find(std::string_view name, const std::string& where) const;

  /// Returns the path of a file that the scene refers to as `name`. The file need not exist. Throws Error at `where` if the
  /// path lies outside both the scene's folder and the asset root.
  std::filesystem::path resolve(std::string_view name, const std::string& where) const;

  /// Returns the contents of a regular file. Throws Error at `where` if the file cannot be read, or if this object would read
  /// more than 1 GiB of text in total, because a few lines may include the same file many times.
  std::string read_text(const std::filesystem::path& file, const std::string& where);

 private:
  SideFolders folders_;
  std::size_t budget_bytes_ = std::size_t{1} << 30;
};

}  // namespace lippmann::tachyon
