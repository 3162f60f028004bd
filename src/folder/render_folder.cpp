#include "folder/render_folder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <span>
#include <thread>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/platform.hpp"
#include "folder/journal_writer.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

FolderJournal journal_of(const fs::path& folder, const std::string& job) {
  FolderJournal journal = read_journal(folder).value_or(FolderJournal{});
  if (!journal.job.empty() && journal.job != job && journal.problem.empty())
    throw Error(folder.string(), "holds another render", "another folder");
  require_sound(folder, journal);
  return journal;
}

/// Syncs the parent folders, so that the new folder survives a power loss.
fs::path made_journal_folder(const fs::path& folder) {
  make_folder(journal_folder(folder));
  for (const fs::path& made : {folder, fs::absolute(folder / "").parent_path().parent_path()}) platform::sync_folder(made);
  return journal_folder(folder);
}

FileChecksum written_checksum(const fs::path& file) {
  const std::optional<FileChecksum> sum = file_checksum(file);
  if (!sum) throw Error(file.string(), "cannot be read back to take its checksum");
  return *sum;
}

/// Journal files that runs of other jobs still write, also in the subfolder kSingleFolder.
std::vector<fs::path> other_runs(const fs::path& folder, const std::string& job) {
  const std::optional<FolderJournal> journal = read_journal(folder);
  if (!journal) return {};
  std::vector<fs::path> runs;
  for (const auto* parts : {&journal->claims, &journal->parts})
    for (const fs::path& part : *parts)
      if (const std::string of_part = read_journal_part(part).job; !of_part.empty() && of_part != job && is_held(part))
        runs.push_back(part);
  if (journal->job == job || !journal->companions.contains(kSingleFolder)) return runs;
  const std::vector<fs::path> beside = other_runs(folder / kSingleFolder, {});
  runs.insert(runs.end(), beside.begin(), beside.end());
  return runs;
}

/// Waits until runs of other jobs that began at the same time have stopped. The run whose journal file comes first by name
/// continues. All other runs stop before they record frames.
void wait_for_others_to_give_way(const fs::path& folder, const std::string& job, const fs::path& own) {
  constexpr int kTries = 40;
  constexpr std::chrono::milliseconds kBetween(50);
  const auto gives_way = [&](const fs::path& part) {
    return own.filename() < part.filename() && read_journal_part(part).asked.empty();
  };
  for (int i = 0; i < kTries; ++i) {
    const std::vector<fs::path> others = other_runs(folder, job);
    if (others.empty() || !std::all_of(others.begin(), others.end(), gives_way)) return;
    std::this_thread::sleep_for(kBetween);
  }
}

}  // namespace

RenderFolder::RenderFolder(fs::path folder, const std::string& job, const MakeRoom& make_room)
    : folder_(std::move(folder)), part_(made_journal_folder(folder_), job) {
  try {
    // The check comes after this run's journal file exists, so that of two runs that begin at the same time, at least
    // one finds the other.
    wait_for_others_to_give_way(folder_, job, part_.path());
    require_no_other_run(folder_, job);
    if (make_room) make_room(part_.path());
    before_ = journal_of(folder_, job);
  } catch (const Error&) {
    part_.remove();
    throw;
  }
}

void require_no_other_run(const fs::path& folder, const std::string& job) {
  const std::vector<fs::path> others = other_runs(folder, job);
  if (others.empty()) return;
  const std::optional<JournalWriter> writer = writer_of(others.front());
  throw Error(folder.string(),
              fmt::format("another render has begun in it and has not ended: process {} on {}", writer->process, writer->host),
              "another folder (`output` DIR); the same settings; this one once the other has ended");
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
    platform::sync_folder(folder_);
    wanted = text_of(now());
  }
}

void RenderFolder::begin_video(const fs::path& video, const std::vector<int>& frames) {
  part_.add(video_line(video_name(folder_, video), frames, std::nullopt));
}

void RenderFolder::add_video(const fs::path& video, const std::vector<int>& frames, bool has_side_file) {
  platform::sync_folder(video.parent_path());
  std::optional<FileChecksum> side;
  if (has_side_file) side = written_checksum(side_name(video.string()));
  part_.add(video_line(video_name(folder_, video), frames, written_checksum(video), side));
}

fs::path folder_of_whole(const fs::path& folder) {
  const fs::path own = fs::absolute(folder / "").lexically_normal().parent_path();
  if (own.filename() != kSingleFolder) return {};
  const std::optional<FolderJournal> journal = read_journal(own.parent_path());
  const bool has_single = journal && journal->problem.empty() && journal->companions.contains(kSingleFolder);
  return has_single ? own.parent_path() : fs::path();
}

std::string video_name(const fs::path& folder, const fs::path& video) {
  return fs::absolute(video).lexically_normal().lexically_relative(fs::absolute(folder / "").lexically_normal()).string();
}

}  // namespace lippmann
