// A new folder for files that nobody keeps.
#pragma once

#include <filesystem>

namespace lippmann {

/// Lies where the system keeps temporary files (TMPDIR), and is removed with all that is in it.
class ScratchFolder {
 public:
  /// Throws Error naming the place where none can be made.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace lippmann
