#include "folder/render_folder.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <span>
#include <system_error>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/host_name.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

bool are_as_recorded(const fs::path& folder, const FileRecords& files) {
  return std::all_of(files.begin(), files.end(),
                     [&](const auto& file) { return file_checksum(folder / file.first) == file.second; });
}

Error cannot_be_written(const fs::path& path, int problem) {
  return Error(path.string(), fmt::format("cannot be written ({})", std::strerror(problem)));
}

/// A file of this run alone that begins with the job's line. Names ascend with time, as far as clocks agree.
fs::path begin_part(const fs::path& folder, const std::string& job) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now).count();
  const std::string name = fmt::format("{:011}-{}-{}", seconds, host_name(), getpid());
  for (int number = 1;; ++number) {
    fs::path path = folder / fmt::format("{}{}.jsonl", name, number == 1 ? "" : fmt::format("-{}", number));
    const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno == EEXIST) continue;
    if (descriptor < 0) throw cannot_be_written(path, errno);
    const std::string line = job_line(job);
    const bool is_written = ::write(descriptor, line.data(), line.size()) == static_cast<ssize_t>(line.size());
    const int problem = errno;
    close(descriptor);
    if (is_written) return path;
    std::error_code ignored;
    fs::remove(path, ignored);
    throw cannot_be_written(path, problem);
  }
}

/// What earlier runs, and those that run now, have recorded for this job.
FolderJournal journal_of(const fs::path& folder, const std::string& job) {
  FolderJournal journal = read_journal(folder).value_or(FolderJournal{});
  if (!journal.job.empty() && journal.job != job && journal.problem.empty())
    throw Error(folder.string(), "holds another render", "another folder");
  require_sound(folder, journal);
  return journal;
}

}  // namespace

RenderFolder::RenderFolder(fs::path folder, const std::string& job) : folder_(std::move(folder)) {
  make_folder(journal_folder(folder_));
  before_ = journal_of(folder_, job);
  part_ = begin_part(journal_folder(folder_), job);
  try {
    journal_of(folder_, job);  // a render of another job may have begun since
  } catch (const Error&) {
    std::error_code ignored;
    fs::remove(part_, ignored);
    throw;
  }
  out_.open(part_, std::ios::app);
}

FolderJournal RenderFolder::now() const { return read_journal(folder_).value_or(FolderJournal{}); }

std::optional<FrameReport> RenderFolder::find(int frame) {
  const auto found = before_.frames.find(frame);
  if (found == before_.frames.end()) return std::nullopt;
  const auto [read, is_new] = is_as_recorded_.emplace(frame, false);
  if (is_new) read->second = are_as_recorded(folder_, found->second.files);
  return read->second ? std::optional(found->second.report) : std::nullopt;
}

void RenderFolder::write(const std::string& name, const std::function<std::string(const FolderJournal&)>& text_of) {
  std::string text, wanted = text_of(now());
  while (text != wanted) {
    text = std::move(wanted);
    const auto bytes = std::as_bytes(std::span(text));
    record(written_line(name, checksum_of(bytes)));
    write_file_atomically(folder_ / name, bytes);
    wanted = text_of(now());
  }
}

void RenderFolder::begin_video(const fs::path& video, const std::vector<int>& frames) {
  record(video_line(video_name(folder_, video), {std::nullopt, frames}));
}

void RenderFolder::add_video(const fs::path& video, const std::vector<int>& frames) {
  const std::optional<FileChecksum> sum = file_checksum(video);
  if (!sum) throw Error(video.string(), "cannot be read back to take its checksum");
  record(video_line(video_name(folder_, video), {sum, frames}));
}

void RenderFolder::record(const std::string& line) {
  out_ << line << std::flush;
  if (!out_) throw cannot_be_written(part_, errno);
}

std::string video_name(const fs::path& folder, const fs::path& video) {
  return fs::absolute(video).lexically_normal().lexically_relative(fs::absolute(folder / "").lexically_normal()).string();
}

}  // namespace lippmann
