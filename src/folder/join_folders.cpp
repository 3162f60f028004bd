#include "folder/join_folders.hpp"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "folder/render_folder.hpp"
#include "folder/strips.hpp"
#include "formats/frame_names.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

FolderJournal journal_of_render(const fs::path& folder) {
  std::optional<FolderJournal> journal = read_journal(folder);
  if (!journal)
    throw Error(folder.string(), "holds no render that can be joined", "a folder that lippmann render has written to");
  require_sound(folder, *journal);
  return *std::move(journal);
}

std::string common_job(const fs::path& folder, const std::vector<fs::path>& others) {
  const std::optional<FolderJournal> there = read_journal(folder);
  const std::string job = there ? there->job : journal_of_render(others.front()).job;
  for (const fs::path& other : others)
    if (journal_of_render(other).job != job)
      throw Error(other.string(), "holds a render of another job than " + folder.string(), "folders with parts of one job");
  return job;
}

/// Links the file atomically if both folders are on one file system, otherwise copies it.
void take_over(const fs::path& from, const fs::path& to) {
  make_folder(to.parent_path());
  AtomicFile file(to);
  std::error_code problem = std::make_error_code(std::errc::cross_device_link), ignored;
  if (!fs::is_symlink(from, ignored)) fs::create_hard_link(from, file.temporary_path(), problem);
  if (problem) problem.clear(), fs::copy_file(from, file.temporary_path(), problem);
  if (problem) throw Error(to.string(), "cannot be copied from " + from.string() + " (" + problem.message() + ")");
  file.commit();
}

void join_strips(const fs::path& other, int frame, const JournalStrips& strips, RenderFolder& folder, JoinedFolders& joined) {
  const FolderJournal there = folder.now();
  for (const auto& [strip, record] : strips.finished) {
    if (find_strip(folder.path(), there, frame, strip)) continue;
    if (!are_as_recorded(other, record.files)) {
      joined.not_as_written.push_back((other / strip_name(frame, strip)).string());
      continue;
    }
    const fs::path file = folder.path() / strip_name(frame, strip);
    take_over(other / strip_name(frame, strip), file);
    sync_names(folder.path(), {file});
    folder.add_strip({frame, strip, strips.count}, record.report, record.files);
  }
}

void join_one(const fs::path& other, RenderFolder& folder, JoinedFolders& joined) {
  const FolderJournal journal = journal_of_render(other);
  folder.begin(journal.asked, journal.companions);
  for (const auto& [frame, record] : journal.frames) {
    if (folder.find(frame) || std::find(joined.frames.begin(), joined.frames.end(), frame) != joined.frames.end()) continue;
    const std::size_t damaged_before = joined.not_as_written.size();
    for (const auto& [name, sum] : record.files)
      if (file_checksum(other / name) != sum) joined.not_as_written.push_back((other / name).string());
    if (joined.not_as_written.size() > damaged_before) continue;
    std::vector<fs::path> files;
    for (const auto& [name, sum] : record.files) {
      files.push_back(folder.path() / name);
      take_over(other / name, files.back());
    }
    sync_names(folder.path(), files);
    folder.add(record.report, record.files);
    joined.frames.push_back(frame);
  }
  for (const auto& [frame, strips] : journal.strips)
    if (!folder.find(frame) && std::find(joined.frames.begin(), joined.frames.end(), frame) == joined.frames.end())
      join_strips(other, frame, strips, folder, joined);
  for (const RunReport& run : journal.runs) folder.end(run);
}

}  // namespace

JoinedFolders join_folders(const fs::path& folder, const std::vector<fs::path>& others) {
  JoinedFolders joined;
  if (others.empty()) return joined;
  std::error_code ignored;
  for (const fs::path& other : others)
    if (fs::equivalent(folder, other, ignored))
      throw Error(other.string(), "is the folder into which the others are joined", "another folder");
  const std::string job = common_job(folder, others);
  make_folder(folder);
  RenderFolder joint(folder, job);
  for (const fs::path& other : others) join_one(other, joint, joined);
  std::sort(joined.frames.begin(), joined.frames.end());
  return joined;
}

}  // namespace lippmann
