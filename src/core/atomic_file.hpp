// Files that appear under their final name only when they are complete: written beside it, then renamed.
//
// A crash of the program leaves at most a hidden file named .<stem>.tmp-<process id>-<host>-<letters><extension> in the same
// folder (the extension is kept because libraries choose a format by it); remove_stale_temporaries clears it away. A loss of
// power may leave what was there before, and never half a file; sync_folder (core/platform.hpp) makes sure that it leaves the
// new one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace lippmann {

/// For code that writes through a library that wants a path: give it temporary_path(), then commit(). One at a time per name.
class AtomicFile {
 public:
  /// Throws Error if the folder is missing or not writable, or the name is taken by something other than a regular file.
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

/// Writes a whole file that way. Throws Error naming `path` when the disk is full or anything else fails.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Removes what processes of this machine that no longer exist have left half-written in a folder; with a `file`, of that file
/// alone. What cannot be read or removed stays.
void remove_stale_temporaries(const std::filesystem::path& folder, const std::filesystem::path& file = {});

}  // namespace lippmann
