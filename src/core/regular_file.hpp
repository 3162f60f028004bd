// Opens files for reading. Rejects everything except regular files and links to them, because opening a FIFO or reading a
// device may never end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/platform.hpp"

namespace lippmann {

/// A file opened for reading at its beginning. Opening never blocks and never throws.
class RegularFile {
 public:
  explicit RegularFile(const std::filesystem::path& path);

  /// Returns the reason why the file cannot be read, to be printed after the file's name, such as "does not exist". Empty if
  /// the file is open.
  const std::string& problem() const { return problem_; }
  bool exists() const { return exists_; }
  std::uintmax_t size() const { return size_; }

  /// Reads `count` bytes, or fewer at the end of the file and on failure. Returns the number of bytes read. A failure sets
  /// problem().
  std::size_t read(void* to, std::size_t count);

 private:
  platform::OpenFile file_;
  bool exists_ = true;
  std::uintmax_t size_ = 0;
  std::string problem_;
};

/// Throw Error that names the file if it cannot be read or is larger than `limit_bytes`. The message ends with `accepted`.
std::string read_file_text(const std::filesystem::path& path, std::uintmax_t limit_bytes, const std::string& accepted = {});
std::vector<std::byte> read_file_bytes(const std::filesystem::path& path, std::uintmax_t limit_bytes,
                                       const std::string& accepted = {});

std::string read_file_begin(const std::filesystem::path& path, std::size_t count);

/// Call this before a library opens the file by name. Throws Error that names the file if it cannot be read.
void require_regular_file(const std::filesystem::path& path, const std::string& accepted = {});

/// Returns true for a regular file, and false if nothing has the name `path`. Throws Error if `path` is something else or
/// cannot be accessed.
bool is_regular_file_there(const std::filesystem::path& path);

}  // namespace lippmann
