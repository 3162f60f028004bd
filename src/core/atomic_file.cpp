#include "core/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/host_name.hpp"
#include "core/synced.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

Error system_failure(const fs::path& path, const std::string& action, int code) {
  return Error(path.string(), action + ": " + std::generic_category().message(code));
}

void check_destination(const fs::path& path) {
  if (path.filename().empty()) throw Error(path.string(), "is not a file name");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) throw Error(path.string(), "there is no folder " + folder.string());
  if (access(folder.c_str(), W_OK | X_OK) != 0) throw system_failure(path, "cannot write into " + folder.string(), errno);
  const fs::file_status status = fs::status(path, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) throw Error(path.string(), "exists and is not a regular file");
}

class FileDescriptor {
 public:
  explicit FileDescriptor(int value) : value_(value) {}
  ~FileDescriptor() { close(); }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  int value() const { return value_; }
  /// 0, or the errno of a delayed write error.
  int close() {
    if (value_ < 0) return 0;
    return ::close(std::exchange(value_, -1)) == 0 ? 0 : errno;
  }

 private:
  int value_;
};

constexpr std::string_view kMark = ".tmp-";

/// Eight letters that no other file has: processes in containers may share a machine's name and their numbers.
std::string unique_letters() {
  std::uint32_t number = 0;
  if (getentropy(&number, sizeof(number)) != 0) number = 0;
  return fmt::format("{:08x}", number);
}

/// Where the mark begins in `.STEM.tmp-PID-HOST-LETTERS.EXT` with this machine's name, and PID; nothing for other names.
struct TemporaryName {
  std::size_t mark;
  pid_t process;
};

std::optional<TemporaryName> parse_temporary(std::string_view name) {
  const std::size_t mark = name.rfind(kMark);
  if (!name.starts_with('.') || mark == std::string_view::npos || mark < 2) return std::nullopt;
  const std::string_view rest = name.substr(mark + kMark.size());
  pid_t process = 0;
  const auto [end, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), process);
  if (problem != std::errc{} || process <= 0) return std::nullopt;
  const std::string_view after = rest.substr(static_cast<std::size_t>(end - rest.data()));
  constexpr std::size_t kLetters = 9;  // with the dash before them
  const std::string_view name_and_letters = after.substr(0, after.find('.'));
  if (name_and_letters.size() < kLetters) return std::nullopt;
  if (name_and_letters.substr(0, name_and_letters.size() - kLetters) != fmt::format("-{}", host_name())) return std::nullopt;
  return TemporaryName{mark, process};
}

bool is_gone(pid_t process) { return kill(process, 0) != 0 && errno == ESRCH; }

}  // namespace

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)) {
  check_destination(path_);
  temporary_path_ = path_.parent_path() / fmt::format(".{}{}{}-{}-{}{}", path_.stem().string(), kMark, getpid(), host_name(),
                                                      unique_letters(), path_.extension().string());
}

AtomicFile::~AtomicFile() {
  if (!committed_) unlink(temporary_path_.c_str());
}

void AtomicFile::commit() {
  sync_file(temporary_path_);
  if (rename(temporary_path_.c_str(), path_.c_str()) != 0) throw system_failure(path_, "cannot be put in place", errno);
  committed_ = true;
}

void write_file_atomically(const fs::path& path, std::span<const std::byte> bytes) {
  AtomicFile file(path);
  FileDescriptor descriptor(open(file.temporary_path().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (descriptor.value() < 0) throw system_failure(path, "cannot be created", errno);
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor.value(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw system_failure(path, "cannot be written", errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  if (const int code = descriptor.close(); code != 0) throw system_failure(path, "cannot be written", code);
  file.commit();
}

void remove_stale_temporaries(const fs::path& folder, const fs::path& file) {
  std::error_code problem;
  fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, problem);
  for (; !problem && entry != fs::directory_iterator(); entry.increment(problem)) {
    const std::string name = entry->path().filename().string();
    const std::optional<TemporaryName> temporary = parse_temporary(name);
    if (!temporary || !is_gone(temporary->process)) continue;
    const bool of_file = name.substr(1, temporary->mark - 1) == file.stem() && entry->path().extension() == file.extension();
    if (file.empty() || of_file) unlink(entry->path().c_str());
  }
}

}  // namespace lippmann
