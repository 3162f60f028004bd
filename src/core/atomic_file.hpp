// Files that appear under their final name only when complete: they are written under another name in the same folder and then
// renamed.
//
// After a crash, at most a hidden file named .<stem>.tmp-<process id>-<host>-<letters><extension> remains in the same folder
// (libraries need the extension to choose a format); remove_stale_temporaries() removes it. After a loss of power, the file may
// have its previous contents, but never half of the new ones. Call sync_folder (core/platform.hpp) to make sure that the new
// file survives.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace lippmann {

/// A file that a library writes by its path: pass temporary_path() to the library, then call commit().
class AtomicFile {
 public:
  /// Throws Error if the folder is missing or not writable, or if the name belongs to something other than a regular file.
  explicit AtomicFile(std::filesystem::path path);
  /// Removes the temporary file unless commit() succeeded.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& temporary_path() const { return temporary_path_; }

  /// Syncs the temporary file, which must exist and be closed, and renames it over path(). Throws Error.
  void commit();

 private:
  std::filesystem::path path_, temporary_path_;
  bool committed_ = false;
};

/// Writes a whole file atomically. Throws Error that names `path` if the disk is full or anything else fails.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Removes incomplete files from a folder if the process of this machine that wrote them has ended. With `file`, removes only
/// those of that file. Ignores files that cannot be read or removed.
void remove_stale_temporaries(const std::filesystem::path& folder, const std::filesystem::path& file = {});

}  // namespace lippmann
