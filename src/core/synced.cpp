#include "core/synced.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

/// 0, or an errno. A folder that may not be read cannot be synced, either.
int sync_path(const char* path, int flags) {
  const int descriptor = open(path, O_RDONLY | O_CLOEXEC | flags);
  if (descriptor < 0) return errno == EACCES ? 0 : errno;
  const int problem = sync_descriptor(descriptor);
  close(descriptor);
  return problem;
}

void require(int problem, const std::filesystem::path& path) {
  if (problem == 0) return;
  throw Error(path.string(), fmt::format("cannot be written to the disk ({})", std::generic_category().message(problem)));
}

}  // namespace

int sync_descriptor(int descriptor) {
  while (fsync(descriptor) != 0) {
    if (errno == EINTR) continue;
    const bool is_unknown = errno == EINVAL || errno == ENOTSUP || errno == ENOSYS;
    return is_unknown ? 0 : errno;
  }
  return 0;
}

void sync_file(const std::filesystem::path& file) { require(sync_path(file.c_str(), 0), file); }

void sync_folder(const std::filesystem::path& folder) {
  require(sync_path(folder.empty() ? "." : folder.c_str(), O_DIRECTORY), folder);
}

}  // namespace lippmann
