#include "folder/journal_writer.hpp"

#include <fmt/core.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <system_error>

#include "core/platform.hpp"
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

using platform::ProcessHandle;

/// Returns act(writing process), or false if no process of this machine writes the file. The process is opened before
/// it is checked, so that its id cannot be reused in between.
bool with_writer(const fs::path& part, bool (*act)(const ProcessHandle&)) {
  const std::optional<JournalWriter> writer = writer_of(part);
  if (!writer || !writer->is_of_this_machine()) return false;
  const ProcessHandle process(writer->process);
  return process.is_there() && process.writes(part) && act(process);
}

/// Returns whether this process may list the open files of the writer, or the writer has ended.
bool can_be_seen(const JournalWriter& writer) {
  if (!writer.is_of_this_machine()) return false;
  const ProcessHandle process(writer.process);
  return !process.is_there() || process.is_visible();
}

double seconds_since_written(const fs::path& part) {
  std::error_code gone;
  const auto written = fs::last_write_time(part, gone);
  const auto age = fs::file_time_type::clock::now() - written;
  return gone ? kLeaseSeconds : std::abs(std::chrono::duration<double>(age).count());
}

}  // namespace

bool JournalWriter::is_of_this_machine() const { return host == platform::host_name(); }

std::optional<JournalWriter> writer_of(const fs::path& part) {
  // Host names may contain dashes and digits, so the name of this machine is matched exactly. For other machines, the
  // last number is the process id.
  static const TextPattern own("([0-9]{1,15})-(" + platform::host_name() + R"()-([0-9]{1,9})(?:-[0-9]{1,9})?\.jsonl)");
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
  return with_writer(part, [](const ProcessHandle& process) { return process.interrupt(); });
}

}  // namespace lippmann
