#include "core/regular_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

std::string not_regular(mode_t mode) {
  const char* kind = S_ISDIR(mode)                    ? "a folder"
                     : S_ISFIFO(mode)                 ? "a FIFO"
                     : S_ISSOCK(mode)                 ? "a socket"
                     : S_ISCHR(mode) || S_ISBLK(mode) ? "a device"
                                                      : "something else";
  return fmt::format("is not a regular file but {}", kind);
}

std::string text_of(int error) { return std::generic_category().message(error); }

Error unreadable(const RegularFile& file, const fs::path& path, const std::string& accepted) {
  return Error(path.string(), file.exists() ? file.problem() : "there is no such file", accepted);
}

std::string readable_size(std::uintmax_t bytes) {
  constexpr std::uintmax_t kMega = std::uintmax_t{1} << 20;
  return bytes % kMega == 0 ? fmt::format("{} MiB", bytes / kMega) : fmt::format("{} bytes", bytes);
}

template <class Contents>
Contents read_whole(const fs::path& path, std::uintmax_t limit_bytes, const std::string& accepted) {
  RegularFile file(path);
  if (!file.problem().empty()) throw unreadable(file, path, accepted);
  if (file.size() > limit_bytes)
    throw Error(path.string(), fmt::format("is too large: {} bytes", file.size()),
                fmt::format("{} of at most {}", accepted.empty() ? "a file" : accepted, readable_size(limit_bytes)));
  Contents contents(static_cast<std::size_t>(file.size()), {});
  const std::size_t read = file.read(contents.data(), contents.size());
  if (!file.problem().empty()) throw unreadable(file, path, accepted);
  if (read < contents.size()) throw Error(path.string(), "cannot be read to its end: it was cut while it was read");
  return contents;
}

}  // namespace

RegularFile::RegularFile(const fs::path& path) : descriptor_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
  struct stat status {};
  const int error = descriptor_ < 0 ? errno : 0;
  if (descriptor_ < 0 && stat(path.c_str(), &status) != 0) {  // one that may not be opened has a kind as well
    exists_ = errno != ENOENT && errno != ENOTDIR;
    problem_ = exists_ ? fmt::format("cannot be opened ({})", text_of(error)) : "does not exist";
  } else if (descriptor_ >= 0 && fstat(descriptor_, &status) != 0) {
    problem_ = fmt::format("cannot be read ({})", text_of(errno));
  } else if (!S_ISREG(status.st_mode)) {
    problem_ = not_regular(status.st_mode);
  } else if (error != 0) {
    problem_ = fmt::format("cannot be opened ({})", text_of(error));
  }
  if (problem_.empty()) size_ = static_cast<std::uintmax_t>(status.st_size);
}

RegularFile::~RegularFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

std::size_t RegularFile::read(void* to, std::size_t count) {
  constexpr std::size_t kMostAtOnce = std::size_t{1} << 30;
  std::size_t done = 0;
  while (problem_.empty() && done < count) {
    const ssize_t read = ::read(descriptor_, static_cast<char*>(to) + done, std::min(count - done, kMostAtOnce));
    if (read < 0 && errno == EINTR) continue;
    if (read < 0) problem_ = fmt::format("cannot be read ({})", text_of(errno));
    if (read <= 0) break;
    done += static_cast<std::size_t>(read);
  }
  return done;
}

std::string read_file_text(const fs::path& path, std::uintmax_t limit_bytes, const std::string& accepted) {
  return read_whole<std::string>(path, limit_bytes, accepted);
}

std::vector<std::byte> read_file_bytes(const fs::path& path, std::uintmax_t limit_bytes, const std::string& accepted) {
  return read_whole<std::vector<std::byte>>(path, limit_bytes, accepted);
}

std::string read_file_begin(const fs::path& path, std::size_t count) {
  RegularFile file(path);
  std::string begin(static_cast<std::size_t>(std::min<std::uintmax_t>(count, file.size())), '\0');
  begin.resize(file.read(begin.data(), begin.size()));
  return begin;
}

void require_regular_file(const fs::path& path, const std::string& accepted) {
  const RegularFile file(path);
  if (!file.problem().empty()) throw unreadable(file, path, accepted);
}

bool is_regular_file_there(const fs::path& path) {
  struct stat status {};
  constexpr const char* kAccepted = "a file, or nothing of that name";
  if (stat(path.c_str(), &status) == 0) {
    if (S_ISREG(status.st_mode)) return true;
    throw Error(path.string(), not_regular(status.st_mode), kAccepted);
  }
  const int error = errno;
  const bool dangles = lstat(path.c_str(), &status) == 0 && S_ISLNK(status.st_mode);
  if ((error == ENOENT || error == ENOTDIR) && !dangles) return false;
  throw Error(path.string(), dangles ? "is a link that leads nowhere" : fmt::format("cannot be looked at ({})", text_of(error)),
              kAccepted);
}

}  // namespace lippmann
