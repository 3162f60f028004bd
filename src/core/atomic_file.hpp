// Writes files that appear under their final name only when complete. A file is written under a temporary name in the same
// folder and then renamed.
//
// The temporary name is .<stem>.tmp-<process id>-<host>-<letters><extension>. It keeps the extension because libraries choose a
// format by it. After a loss of power, a file has either its previous or its new contents. Call sync_folder (core/platform.hpp)
// to make sure that the new contents survive.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace lippmann {

/// A file that a library writes by its path: pass temporary_path() to the library, then call commit(). Without commit(), the
/// destructor removes the file.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
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

void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Removes the temporary files in a folder whose process ran on this machine and has ended. If `file` is not empty, removes
/// only its temporary files. Ignores files that cannot be removed.
void remove_stale_temporaries(const std::filesystem::path& folder, const std::filesystem::path& file = {});

}  // namespace lippmann
