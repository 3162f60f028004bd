#include "folder/journal_part.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/host_name.hpp"
#include "core/synced.hpp"
#include "folder/journal.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

Error part_cannot_be_written(const fs::path& path, int problem) {
  return Error(path.string(), fmt::format("cannot be written ({})", std::generic_category().message(problem)));
}

/// 0, or an errno.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// Whether a path still leads to the open file.
bool leads_to(const fs::path& path, int descriptor) {
  struct stat named {
  }, opened{};
  return stat(path.c_str(), &named) == 0 && fstat(descriptor, &opened) == 0 && named.st_ino == opened.st_ino &&
         named.st_dev == opened.st_dev;
}

/// Names ascend with time, as far as clocks agree.
std::string first_name() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now).count();
  return fmt::format("{:011}-{}-{}", seconds, host_name(), getpid());
}

}  // namespace

JournalPart::JournalPart(const fs::path& folder, const std::string& job) {
  const std::string name = first_name();
  for (int number = 1; descriptor_ < 0; ++number) {
    path_ = folder / fmt::format("{}{}.jsonl", name, number == 1 ? "" : fmt::format("-{}", number));
    descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) throw part_cannot_be_written(path_, errno);
  }
  try {
    add(job_line(job));
    sync_folder(folder);
  } catch (const Error&) {
    remove();
    close(descriptor_);
    throw;
  }
}

JournalPart::~JournalPart() {
  if (descriptor_ >= 0) close(descriptor_);
}

JournalPart::JournalPart(JournalPart&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)), problem_(other.problem_) {}

void JournalPart::add(const std::string& line) {
  if (problem_ == 0) problem_ = write_all(descriptor_, line);
  if (problem_ == 0) problem_ = sync_descriptor(descriptor_);
  if (problem_ != 0) throw part_cannot_be_written(path_, problem_);
  if (leads_to(path_, descriptor_)) return;
  problem_ = ENOENT;
  throw Error(path_.string(), "is gone: its folder was removed or moved while a render wrote into it",
              "a folder that stays where it is until the render has ended");
}

void JournalPart::renew() const { futimens(descriptor_, nullptr); }

void JournalPart::remove() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

}  // namespace lippmann
