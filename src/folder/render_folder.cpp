#include "folder/render_folder.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/synced.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// What earlier runs, and those that run now, have recorded for this job.
FolderJournal journal_of(const fs::path& folder, const std::string& job) {
  FolderJournal journal = read_journal(folder).value_or(FolderJournal{});
  if (!journal.job.empty() && journal.job != job && journal.problem.empty())
    throw Error(folder.string(), "holds another render", "another folder");
  require_sound(folder, journal);
  return journal;
}

/// What a run finds. The folders will be there after a loss of power, whoever has made them a moment ago.
FolderJournal found_in(const fs::path& folder, const std::string& job) {
  make_folder(journal_folder(folder));
  for (const fs::path& made : {folder, fs::absolute(folder / "").parent_path().parent_path()}) sync_folder(made);
  return journal_of(folder, job);
}

}  // namespace

RenderFolder::RenderFolder(fs::path folder, const std::string& job)
    : folder_(std::move(folder)), before_(found_in(folder_, job)), part_(journal_folder(folder_), job) {
  try {
    journal_of(folder_, job);  // a render of another job may have begun since
  } catch (const Error&) {
    part_.remove();
    throw;
  }
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
    part_.add(written_line(name, checksum_of(bytes)));
    write_file_atomically(folder_ / name, bytes);
    sync_folder(folder_);
    wanted = text_of(now());
  }
}

void RenderFolder::begin_video(const fs::path& video, const std::vector<int>& frames) {
  part_.add(video_line(video_name(folder_, video), frames, std::nullopt));
}

void RenderFolder::add_video(const fs::path& video, const std::vector<int>& frames) {
  sync_folder(video.parent_path());
  const std::optional<FileChecksum> sum = file_checksum(video);
  if (!sum) throw Error(video.string(), "cannot be read back to take its checksum");
  part_.add(video_line(video_name(folder_, video), frames, sum));
}

std::string video_name(const fs::path& folder, const fs::path& video) {
  return fs::absolute(video).lexically_normal().lexically_relative(fs::absolute(folder / "").lexically_normal()).string();
}

}  // namespace lippmann
