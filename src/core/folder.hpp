#pragma once

#include <filesystem>
#include <vector>

namespace lippmann {

/// Creates a folder and its parents. Throws Error that names the folder on failure.
void make_folder(const std::filesystem::path& folder);

/// Removes a file, a link or an empty folder. Does nothing if `path` does not exist. Throws Error that names `path` on failure.
void remove_if_there(const std::filesystem::path& path);

/// Creates a folder as make_folder() does. The destructor removes the created folders that are still empty, so that a failure
/// leaves nothing behind.
class NewFolder {
 public:
  explicit NewFolder(std::filesystem::path folder);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  ///< folders that the constructor created, the deepest first
};

}  // namespace lippmann
