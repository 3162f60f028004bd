// The files beside a scene file that it may name: found inside the scene's own folder and nowhere else, read within a budget.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace lippmann::tachyon {

class SceneFolder {
 public:
  /// scene_file: the .dat file; its folder is the one that side files must lie in.
  explicit SceneFolder(const std::filesystem::path& scene_file);

  /// Where a side file is that the scene calls `name`, relative to the folder. Throws Error at `where` for absolute names,
  /// names with `..` and links that lead outside. The file need not exist.
  std::filesystem::path resolve(std::string_view name, const std::string& where) const;

  /// The contents of a regular file. Throws Error at `where` if it cannot be read, or when all text read through this object
  /// would exceed 1 GiB: a few lines may include the same file many times.
  std::string read_text(const std::filesystem::path& file, const std::string& where);

 private:
  std::filesystem::path folder_;
  std::size_t budget_bytes_ = std::size_t{1} << 30;
};

}  // namespace lippmann::tachyon
