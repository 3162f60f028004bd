#include "folder/folder_check.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <system_error>
#include <utility>

#include "core/folder_entries.hpp"
#include "formats/frame_names.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

bool is_of_strip(const FolderJournal& journal, int frame, const std::string& name) {
  const auto found = journal.strips.find(frame);
  return found != journal.strips.end() && std::any_of(found->second.finished.begin(), found->second.finished.end(),
                                                      [&](const auto& strip) { return strip.second.files.contains(name); });
}

bool is_of_frame(const FolderJournal& journal, int frame, const std::string& name) {
  if (is_of_strip(journal, frame, name)) return true;
  const auto found = journal.frames.find(frame);
  return found != journal.frames.end() && found->second.files.contains(name);
}

/// Adds the foreign files in the subfolder `below` of `folder`, and in its folders of views.
void add_foreign(const fs::path& folder, const fs::path& below, const FolderJournal& journal,
                 std::vector<std::string>& foreign) {
  for (const fs::directory_entry& entry : entries_of(folder / below)) {
    const fs::path name = below / entry.path().filename();
    std::error_code ignored;
    const bool is_folder = entry.symlink_status(ignored).type() == fs::file_type::directory;
    const std::optional<int> frame = is_folder ? std::nullopt : frame_of_file(name.string());
    if (frame && !is_of_frame(journal, *frame, name.string())) foreign.push_back(name.string());
    if (is_folder && below.empty() && name.string().starts_with("frame_")) add_foreign(folder, name, journal, foreign);
  }
}

enum class FileState { kMissing, kDamaged, kSound };

FileState state_of(const fs::path& file, const std::vector<FileChecksum>& sums) {
  std::error_code problem;
  if (!fs::exists(fs::symlink_status(file, problem))) return FileState::kMissing;
  return is_as_written(file, sums) ? FileState::kSound : FileState::kDamaged;
}

void add_file(const std::string& name, FileState state, FolderCheck& check) {
  ++check.files;
  if (state == FileState::kMissing) check.missing.push_back(name);
  if (state == FileState::kDamaged) check.damaged.push_back(name);
}

void add_file(const fs::path& folder, const std::string& name, const std::vector<FileChecksum>& sums, FolderCheck& check) {
  add_file(name, state_of(folder / name, sums), check);
}

/// Strips of finished frames are not checked.
void add_strips(const fs::path& folder, int frame, const JournalStrips& strips, FolderCheck& check) {
  const std::size_t wrong_before = check.missing.size() + check.damaged.size();
  for (const auto& [strip, record] : strips.finished)
    for (const auto& [name, sum] : record.files) add_file(folder, name, {sum}, check);
  std::vector<int> left;
  for (int strip = 0; strip < strips.count; ++strip)
    if (!strips.finished.contains(strip)) left.push_back(strip);
  const bool are_sound = wrong_before == check.missing.size() + check.damaged.size();
  if (left.empty() && are_sound) check.joinable.push_back(frame);
  if (!left.empty()) check.strips_left[frame] = std::move(left);
}

void add_strips(const fs::path& folder, const FolderJournal& journal, FolderCheck& check) {
  for (const auto& [frame, strips] : journal.strips) {
    const auto finished = journal.frames.find(frame);
    if (finished != journal.frames.end() && are_as_recorded(folder, finished->second.files)) continue;
    add_strips(folder, frame, strips, check);
  }
}

std::set<std::string> videos_of_single(const fs::path& folder, const FolderJournal& journal) {
  std::set<std::string> names;
  if (!journal.companions.contains(kSingleFolder)) return names;
  const FolderJournal single = read_journal(folder / kSingleFolder).value_or(FolderJournal{});
  for (const auto& [name, video] : single.videos) names.insert((fs::path(kSingleFolder) / name).lexically_normal().string());
  return names;
}

/// Checks the render in kSingleFolder. A folder without a journal counts as missing.
void add_single(const fs::path& folder, FolderCheck& check) {
  const std::optional<FolderJournal> journal = read_journal(folder / kSingleFolder);
  if (!journal || journal->job.empty()) return add_file(kSingleFolder, FileState::kMissing, check);
  const FolderCheck single = check_folder(folder / kSingleFolder);
  check.files += single.files;
  for (auto [from, to] : {std::pair(&single.missing, &check.missing), std::pair(&single.damaged, &check.damaged),
                          std::pair(&single.foreign, &check.foreign)})
    for (const std::string& name : *from) to->push_back((fs::path(kSingleFolder) / name).lexically_normal().string());
  if (!single.unfinished.empty()) check.unfinished_beside[kSingleFolder] = single.unfinished;
}

void add_companions(const fs::path& folder, const FolderJournal& journal, FolderCheck& check) {
  if (journal.companions.contains(kSingleFolder)) add_single(folder, check);
  if (!journal.companions.contains(kPageFolder)) return;
  if (journal.page.empty()) add_file(kPageFolder, FileState::kMissing, check);
  for (const auto& [name, sum] : journal.page) add_file(folder, name, {sum}, check);
}

}  // namespace

std::vector<std::string> foreign_files(const fs::path& folder, const FolderJournal& journal) {
  std::vector<std::string> foreign;
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) add_foreign(folder, {}, journal, foreign);
  std::sort(foreign.begin(), foreign.end());
  return foreign;
}

FolderCheck check_folder(const fs::path& folder) {
  const std::optional<FolderJournal> journal = read_journal(folder);
  if (!journal || journal->job.empty())
    throw Error(folder.string(), "cannot be checked: it has no journal of a render (.lippmann)",
                "a folder that lippmann render has written to");
  require_sound(folder, *journal);
  FolderCheck check;
  check.frames = static_cast<int>(journal->frames.size());
  for (const auto& [frame, record] : journal->frames)
    for (const auto& [name, sum] : record.files) add_file(folder, name, {sum}, check);
  add_strips(folder, *journal, check);
  for (const auto& [name, sums] : journal->files) add_file(folder, name, sums, check);
  const std::set<std::string> checked_beside = videos_of_single(folder, *journal);
  for (const auto& [name, video] : journal->videos) {
    if (checked_beside.contains(name)) continue;
    add_file(folder, name, video.sums, check);
    if (!video.side.empty()) add_file(folder, side_name(name), video.side, check);
  }
  add_companions(folder, *journal, check);
  std::copy_if(journal->asked.begin(), journal->asked.end(), std::back_inserter(check.unfinished),
               [&](int frame) { return !journal->frames.contains(frame); });
  check.foreign = foreign_files(folder, *journal);
  std::erase_if(check.foreign, [&](const std::string& name) { return is_unfinished(*journal, name); });
  return check;
}

}  // namespace lippmann
