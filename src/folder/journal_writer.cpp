#include "folder/journal_writer.hpp"

#include <fmt/core.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <system_error>
#include <utility>

#include "core/host_name.hpp"
#include "core/text_pattern.hpp"
#include "folder/journal.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

template <class Number>
Number number_of_digits(const std::string& digits) {
  Number number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

/// A process as such: its number may become another's, this does not. By the system's own calls, which glibc wraps since 2.36.
class ProcessHandle {
 public:
  explicit ProcessHandle(int process) : descriptor_(process > 0 ? static_cast<int>(syscall(SYS_pidfd_open, process, 0)) : -1) {}
  ~ProcessHandle() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  ProcessHandle(const ProcessHandle&) = delete;
  ProcessHandle& operator=(const ProcessHandle&) = delete;

  bool is_there() const { return descriptor_ >= 0; }
  bool send(int signal) const { return syscall(SYS_pidfd_send_signal, descriptor_, signal, nullptr, 0) == 0; }

 private:
  int descriptor_;
};

/// The link to an open file is writable where the file was opened for writing.
bool is_open_for_writing(const fs::path& link, const struct stat& file) {
  struct stat opened {
  }, itself{};
  return stat(link.c_str(), &opened) == 0 && lstat(link.c_str(), &itself) == 0 && opened.st_dev == file.st_dev &&
         opened.st_ino == file.st_ino && (itself.st_mode & S_IWUSR) != 0;
}

std::string open_files_of(int process) { return fmt::format("/proc/{}/fd", process); }

bool has_open_for_writing(int process, const fs::path& path) {
  struct stat file {};
  if (stat(path.c_str(), &file) != 0) return false;
  std::error_code problem;
  fs::directory_iterator links(open_files_of(process), problem);
  for (; !problem && links != fs::directory_iterator(); links.increment(problem))
    if (is_open_for_writing(links->path(), file)) return true;
  return false;
}

/// The process of a part, if that process writes it. It is opened before it is looked at, so that what is looked at is it.
bool with_writer(const fs::path& part, bool (*act)(const ProcessHandle&)) {
  const std::optional<JournalWriter> writer = writer_of(part);
  if (!writer || !writer->is_of_this_machine()) return false;
  const ProcessHandle process(writer->process);
  return process.is_there() && has_open_for_writing(writer->process, part) && act(process);
}

/// Whether this process may see which files that one has open. One that is gone has none.
bool can_be_seen(const JournalWriter& writer) {
  if (!writer.is_of_this_machine()) return false;
  return !ProcessHandle(writer.process).is_there() || access(open_files_of(writer.process).c_str(), R_OK) == 0;
}

double seconds_since_written(const fs::path& part) {
  std::error_code gone;
  const auto written = fs::last_write_time(part, gone);
  const auto age = fs::file_time_type::clock::now() - written;
  return gone ? kLeaseSeconds : std::abs(std::chrono::duration<double>(age).count());
}

}  // namespace

bool JournalWriter::is_of_this_machine() const { return host == host_name(); }

std::optional<JournalWriter> writer_of(const fs::path& part) {
  // Names of machines may have dashes and digits: this machine's is known, of others the number is what stands last.
  static const TextPattern own("([0-9]{1,15})-(" + host_name() + R"()-([0-9]{1,9})(?:-[0-9]{1,9})?\.jsonl)");
  static const TextPattern any(R"(([0-9]{1,15})-([A-Za-z0-9-]{1,64})-([0-9]{1,9})\.jsonl)");
  const std::string name = part.filename().string();
  std::optional<PatternMatch> found = own.match(name);
  if (!found) found = any.match(name);
  if (!found) return std::nullopt;
  return JournalWriter{found->groups[2], number_of_digits<int>(found->groups[3]),
                       double(number_of_digits<long long>(found->groups[1]))};
}

bool is_being_written(const fs::path& part) {
  return with_writer(part, [](const ProcessHandle&) { return true; });
}

bool is_held(const fs::path& part) {
  const std::optional<JournalWriter> writer = writer_of(part);
  if (!writer || is_being_written(part)) return writer.has_value();
  if (can_be_seen(*writer)) return false;
  return seconds_since_written(part) < kLeaseSeconds && read_journal_part(part).runs.empty();
}

bool interrupt_writer(const fs::path& part) {
  return with_writer(part, [](const ProcessHandle& process) { return process.send(SIGINT); });
}

}  // namespace lippmann
