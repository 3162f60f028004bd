#include "core/atomic_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/platform.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

Error system_failure(const fs::path& path, const std::string& action, const std::error_code& problem) {
  return Error(path.string(), action + ": " + problem.message());
}

void check_destination(const fs::path& path) {
  if (path.filename().empty()) throw Error(path.string(), "is not a file name");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) throw Error(path.string(), "there is no folder " + folder.string());
  if (const std::error_code problem = platform::check_writable(folder))
    throw system_failure(path, "cannot write into " + folder.string(), problem);
  const fs::file_status status = fs::status(path, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) throw Error(path.string(), "exists and is not a regular file");
}

constexpr std::string_view kMark = ".tmp-";

std::string unique_letters() { return fmt::format("{:08x}", platform::random_bits()); }

/// A parsed file name of the form `.STEM.tmp-PID-HOST-LETTERS.EXT`, where HOST is this machine.
struct TemporaryName {
  std::size_t mark;
  int process;
};

std::optional<TemporaryName> parse_temporary(std::string_view name) {
  const std::size_t mark = name.rfind(kMark);
  if (!name.starts_with('.') || mark == std::string_view::npos || mark < 2) return std::nullopt;
  const std::string_view rest = name.substr(mark + kMark.size());
  int process = 0;
  const auto [end, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), process);
  if (problem != std::errc{} || process <= 0) return std::nullopt;
  const std::string_view after = rest.substr(static_cast<std::size_t>(end - rest.data()));
  constexpr std::size_t kLetters = 9;
  const std::string_view name_and_letters = after.substr(0, after.find('.'));
  if (name_and_letters.size() < kLetters) return std::nullopt;
  if (name_and_letters.substr(0, name_and_letters.size() - kLetters) != fmt::format("-{}", platform::host_name()))
    return std::nullopt;
  return TemporaryName{mark, process};
}

}  // namespace

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)) {
  check_destination(path_);
  temporary_path_ = path_.parent_path() / fmt::format(".{}{}{}-{}-{}{}", path_.stem().string(), kMark, platform::process_id(),
                                                      platform::host_name(), unique_letters(), path_.extension().string());
}

AtomicFile::~AtomicFile() {
  if (!committed_) platform::remove_file(temporary_path_);
}

void AtomicFile::commit() {
  platform::sync_file(temporary_path_);
  std::error_code problem;
  fs::rename(temporary_path_, path_, problem);
  if (problem) throw system_failure(path_, "cannot be put in place", problem);
  committed_ = true;
}

void write_file_atomically(const fs::path& path, std::span<const std::byte> bytes) {
  AtomicFile file(path);
  std::error_code problem;
  platform::OpenFile output(file.temporary_path(), platform::OpenFile::Mode::kCreate, problem);
  if (problem) throw system_failure(path, "cannot be created", problem);
  problem = output.write(bytes.data(), bytes.size());
  if (!problem) problem = output.close();
  if (problem) throw system_failure(path, "cannot be written", problem);
  file.commit();
}

void remove_stale_temporaries(const fs::path& folder, const fs::path& file) {
  std::error_code problem;
  fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, problem);
  for (; !problem && entry != fs::directory_iterator(); entry.increment(problem)) {
    const std::string name = entry->path().filename().string();
    const std::optional<TemporaryName> temporary = parse_temporary(name);
    if (!temporary || !platform::is_process_gone(temporary->process)) continue;
    const bool of_file = name.substr(1, temporary->mark - 1) == file.stem() && entry->path().extension() == file.extension();
    if (file.empty() || of_file) platform::remove_file(entry->path());
  }
}

}  // namespace lippmann
