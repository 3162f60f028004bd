#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>

#include "core/platform.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::platform {
namespace {

namespace fs = std::filesystem;

std::error_code code_of(int error) { return {error, std::generic_category()}; }

fs::file_type type_of(mode_t mode) {
  if (S_ISREG(mode)) return fs::file_type::regular;
  if (S_ISDIR(mode)) return fs::file_type::directory;
  if (S_ISFIFO(mode)) return fs::file_type::fifo;
  if (S_ISSOCK(mode)) return fs::file_type::socket;
  if (S_ISCHR(mode)) return fs::file_type::character;
  if (S_ISBLK(mode)) return fs::file_type::block;
  return fs::file_type::unknown;
}

int flags_of(OpenFile::Mode mode) {
  constexpr int kNew = O_CREAT | O_EXCL;
  switch (mode) {
    case OpenFile::Mode::kRead:
      return O_RDONLY | O_NONBLOCK | O_CLOEXEC;
    case OpenFile::Mode::kCreate:
      return O_RDWR | kNew | O_CLOEXEC;
    case OpenFile::Mode::kAppend:
      return O_WRONLY | kNew | O_APPEND | O_CLOEXEC;
  }
  return 0;
}

int sync_descriptor(int descriptor) {
  while (fsync(descriptor) != 0) {
    if (errno == EINTR) continue;
    const bool is_unknown = errno == EINVAL || errno == ENOTSUP || errno == ENOSYS;
    return is_unknown ? 0 : errno;
  }
  return 0;
}

/// Throws Error on failure. Unreadable folders cannot be synced and are ignored.
void sync_path(const fs::path& path, int flags) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | flags);
  int problem = 0;
  if (descriptor < 0) {
    problem = errno == EACCES ? 0 : errno;
  } else {
    problem = sync_descriptor(descriptor);
    ::close(descriptor);
  }
  if (problem != 0) throw Error(path.string(), fmt::format("cannot be written to the disk ({})", code_of(problem).message()));
}

}  // namespace

OpenFile::OpenFile(const fs::path& path, Mode mode, std::error_code& problem)
    : descriptor_(open(path.c_str(), flags_of(mode), 0666)) {
  problem = code_of(descriptor_ < 0 ? errno : 0);
}

OpenFile& OpenFile::operator=(OpenFile&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

fs::file_type OpenFile::kind(std::uintmax_t& bytes, std::error_code& problem) const {
  struct stat status {};
  problem = code_of(fstat(descriptor_, &status) == 0 ? 0 : errno);
  if (problem) return fs::file_type::none;
  bytes = static_cast<std::uintmax_t>(status.st_size);
  return type_of(status.st_mode);
}

std::size_t OpenFile::read(void* to, std::size_t count, std::error_code& problem) {
  constexpr std::size_t kMostAtOnce = std::size_t{1} << 30;
  problem.clear();
  std::size_t done = 0;
  while (done < count) {
    const ssize_t read = ::read(descriptor_, static_cast<char*>(to) + done, std::min(count - done, kMostAtOnce));
    if (read < 0 && errno == EINTR) continue;
    if (read < 0) problem = code_of(errno);
    if (read <= 0) break;
    done += static_cast<std::size_t>(read);
  }
  return done;
}

std::error_code OpenFile::write(const void* from, std::size_t count) {
  for (std::size_t done = 0; done < count;) {
    const ssize_t written = ::write(descriptor_, static_cast<const char*>(from) + done, count - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return code_of(errno);
    done += static_cast<std::size_t>(written);
  }
  return {};
}

std::int64_t OpenFile::seek(std::int64_t offset, int whence) { return lseek(descriptor_, static_cast<off_t>(offset), whence); }

std::error_code OpenFile::sync() { return code_of(sync_descriptor(descriptor_)); }

std::error_code OpenFile::close() {
  if (descriptor_ < 0) return {};
  return code_of(::close(std::exchange(descriptor_, -1)) == 0 ? 0 : errno);
}

bool OpenFile::is_at(const fs::path& path) const {
  struct stat named {
  }, opened{};
  return stat(path.c_str(), &named) == 0 && fstat(descriptor_, &opened) == 0 && named.st_ino == opened.st_ino &&
         named.st_dev == opened.st_dev;
}

void OpenFile::renew() const { futimens(descriptor_, nullptr); }

void sync_file(const fs::path& file) { sync_path(file, 0); }

void sync_folder(const fs::path& folder) { sync_path(folder.empty() ? fs::path(".") : folder, O_DIRECTORY); }

std::error_code check_writable(const fs::path& folder) { return code_of(access(folder.c_str(), W_OK | X_OK) == 0 ? 0 : errno); }

void remove_file(const fs::path& file) { unlink(file.c_str()); }

fs::path make_unique_file(const fs::path& prefix, std::error_code& problem) {
  std::string name = prefix.string() + "XXXXXX";
  const int descriptor = mkstemp(name.data());
  problem = code_of(descriptor < 0 ? errno : 0);
  if (descriptor >= 0) close(descriptor);
  return name;
}

fs::path make_unique_folder(const fs::path& prefix, std::error_code& problem) {
  std::string name = prefix.string() + "XXXXXX";
  problem = code_of(mkdtemp(name.data()) ? 0 : errno);
  return name;
}

}  // namespace lippmann::platform
