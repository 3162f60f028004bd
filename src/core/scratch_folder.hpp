// A new folder for temporary files.
#pragma once

#include <filesystem>

namespace lippmann {

/// Located in the system's temporary folder (TMPDIR), and removed with its contents.
class ScratchFolder {
 public:
  /// Throws Error that names the place if no folder can be created.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace lippmann
