#include "folder/journal_part.hpp"

#include <fmt/core.h>

#include <chrono>
#include <system_error>
#include <utility>

#include "core/platform.hpp"
#include "folder/journal.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

Error part_cannot_be_written(const fs::path& path, const std::error_code& problem) {
  return Error(path.string(), fmt::format("cannot be written ({})", problem.message()));
}

/// The name begins with the current time, so that the alphabetical order of names is their order in time.
std::string first_name() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now).count();
  return fmt::format("{:011}-{}-{}", seconds, platform::host_name(), platform::process_id());
}

}  // namespace

JournalPart::JournalPart(const fs::path& folder, const std::string& job) {
  const std::string name = first_name();
  for (int number = 1; !file_.is_open(); ++number) {
    path_ = folder / fmt::format("{}{}.jsonl", name, number == 1 ? "" : fmt::format("-{}", number));
    file_ = platform::OpenFile(path_, platform::OpenFile::Mode::kAppend, problem_);
    if (problem_ && problem_ != std::errc::file_exists) throw part_cannot_be_written(path_, problem_);
  }
  try {
    add(job_line(job));
    platform::sync_folder(folder);
  } catch (const Error&) {
    remove();
    throw;
  }
}

void JournalPart::add(const std::string& line) {
  if (!problem_) problem_ = file_.write(line.data(), line.size());
  if (!problem_) problem_ = file_.sync();
  if (problem_) throw part_cannot_be_written(path_, problem_);
  if (file_.is_at(path_)) return;
  problem_ = std::make_error_code(std::errc::no_such_file_or_directory);
  throw Error(path_.string(), "is gone: its folder was removed or moved while a render wrote into it",
              "a folder that stays where it is until the render has ended");
}

void JournalPart::renew() const { file_.renew(); }

void JournalPart::remove() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

}  // namespace lippmann
