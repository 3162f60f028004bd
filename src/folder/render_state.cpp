#include "folder/render_state.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>

#include "core/folder_entries.hpp"
#include "folder/journal_writer.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

double seconds_since_1970(std::chrono::system_clock::time_point time) {
  return std::chrono::duration<double>(time.time_since_epoch()).count();
}

double written_last(const fs::path& part) {
  std::error_code ignored;
  const auto time = std::chrono::file_clock::to_sys(fs::last_write_time(part, ignored));
  return seconds_since_1970(std::chrono::time_point_cast<std::chrono::system_clock::duration>(time));
}

std::uintmax_t bytes_of_parts(const fs::path& folder) {
  std::uintmax_t bytes = 0;
  std::error_code missing;
  if (!fs::is_directory(journal_folder(folder), missing)) return 0;
  for (const fs::directory_entry& entry : entries_of(journal_folder(folder))) {
    std::error_code gone;
    if (const std::uintmax_t size = entry.file_size(gone); !gone) bytes += size;
  }
  return bytes;
}

int frames_left(const FolderJournal& journal) {
  return static_cast<int>(
      std::count_if(journal.asked.begin(), journal.asked.end(), [&](int frame) { return !journal.frames.contains(frame); }));
}

RenderActivity activity_of(const RenderState& state, int left) {
  if (!state.running.empty()) return RenderActivity::kRunning;
  if (left == 0) return RenderActivity::kFinished;
  return state.elsewhere.empty() ? RenderActivity::kStopped : RenderActivity::kElsewhere;
}

}  // namespace

std::optional<double> estimated_seconds_left(std::span<const RunPace> runs, int frames_left, double now) {
  double frames_a_second = 0.0, last = 0.0;
  for (const RunPace& run : runs) {
    if (run.frames == 0 || run.last <= run.began) continue;
    frames_a_second += run.frames / (run.last - run.began);
    last = std::max(last, run.last);
  }
  if (frames_a_second == 0.0) return std::nullopt;
  return std::max(frames_left / frames_a_second - std::max(now - last, 0.0), 0.0);
}

const FolderJournal& RenderStateReader::part(const fs::path& path) {
  Part& known = parts_[path];
  std::error_code gone;
  const std::uintmax_t bytes = fs::file_size(path, gone);
  if (gone || bytes != known.bytes) known = {gone ? 0 : bytes, read_journal_part(path)};
  return known.journal;
}

std::optional<RenderState> RenderStateReader::read() {
  const std::uintmax_t bytes = bytes_of_parts(folder_);
  if (!journal_ || bytes != bytes_) journal_ = read_journal(folder_), bytes_ = bytes;
  if (!journal_) return std::nullopt;
  require_sound(folder_, *journal_);
  RenderState state;
  state.journal = *journal_;
  std::vector<RunPace> paces;
  for (const fs::path& path : state.journal.parts) {
    const std::optional<JournalWriter> writer = writer_of(path);
    if (writer && !writer->is_of_this_machine() && part(path).runs.empty()) state.elsewhere = writer->host;
    if (!is_being_written(path)) continue;
    state.running.push_back(path);
    paces.push_back({writer->began, written_last(path), static_cast<int>(part(path).frames.size())});
  }
  const int left = frames_left(state.journal);
  state.activity = activity_of(state, left);
  if (state.activity == RenderActivity::kRunning)
    state.seconds_left = estimated_seconds_left(paces, left, seconds_since_1970(std::chrono::system_clock::now()));
  return state;
}

fs::path picture_of(const JournalEntry& frame) {
  for (const auto& [name, sum] : frame.files) {
    const fs::path path(name);
    if (!name.starts_with("frame_")) continue;
    if (path.has_parent_path()) return path.parent_path();
    if (path.extension() != ".json") return path;
  }
  return {};
}

}  // namespace lippmann
