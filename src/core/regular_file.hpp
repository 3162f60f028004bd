// Opens files to read them: scenes, pictures, displays, jobs, journals and whatever lies beside them.
//
// Something else may lie under a name. Opening a FIFO waits for ever, a device has no end, and both block signals; so every
// reader opens files here, and gets an error for all but regular files. Links are followed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/platform.hpp"

namespace lippmann {

/// A file that is open for reading, from its first byte. Opening never waits and never throws.
class RegularFile {
 public:
  explicit RegularFile(const std::filesystem::path& path);

  /// Why it cannot be read, to follow its name: "does not exist", "is not a regular file but a FIFO"; empty if it is open.
  const std::string& problem() const { return problem_; }
  bool exists() const { return exists_; }
  std::uintmax_t size() const { return size_; }

  /// Reads on, up to `count` bytes: fewer only at the file's end or where it cannot be read, which problem() then says.
  std::size_t read(void* to, std::size_t count);

 private:
  platform::OpenFile file_;
  bool exists_ = true;
  std::uintmax_t size_ = 0;
  std::string problem_;
};

/// The whole file. Throws Error naming it if it cannot be read, or is larger than `limit_bytes`; `accepted` says what is
/// accepted in its place.
std::string read_file_text(const std::filesystem::path& path, std::uintmax_t limit_bytes, const std::string& accepted = {});
std::vector<std::byte> read_file_bytes(const std::filesystem::path& path, std::uintmax_t limit_bytes,
                                       const std::string& accepted = {});

/// The first `count` bytes; fewer if the file is shorter, none if it cannot be read.
std::string read_file_begin(const std::filesystem::path& path, std::size_t count);

/// Throws Error naming the file if it cannot be read: for files that a library opens by their name.
void require_regular_file(const std::filesystem::path& path, const std::string& accepted = {});

/// False if there is nothing of that name. Throws Error if there is something that is no regular file, or it cannot be looked
/// at.
bool is_regular_file_there(const std::filesystem::path& path);

}  // namespace lippmann
