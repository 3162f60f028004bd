// Makes the folders that results go into.
#pragma once

#include <filesystem>
#include <vector>

namespace lippmann {

/// Makes a folder and those above it; an empty path is the working folder, which is there. Throws Error naming the folder.
void make_folder(const std::filesystem::path& folder);

/// Removes a file, a link or an empty folder. Throws Error naming it where it remains.
void remove_if_there(const std::filesystem::path& path);

/// As make_folder, for a folder that is to hold results: those folders that were made for it and are still empty when this
/// object goes are removed again, so that a failure leaves nothing behind.
class NewFolder {
 public:
  /// Throws Error naming the folder.
  explicit NewFolder(std::filesystem::path folder);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  ///< the deepest first
};

}  // namespace lippmann
