#include "folder/claim_folder.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "core/folder.hpp"
#include "core/frame_ranges.hpp"
#include "core/platform.hpp"
#include "core/regular_file.hpp"
#include "folder/folder_check.hpp"
#include "folder/journal.hpp"
#include "folder/render_folder.hpp"
#include "folder/strips.hpp"
#include "formats/frame_names.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReport = "report.json";
constexpr const char* kAnotherFolder = "another folder (`output` DIR)";

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

void require_regular_files(const fs::path& folder) {
  for (const char* name : {"job.toml", kReport}) is_regular_file_there(folder / name);
}

struct Contents {
  std::optional<FolderJournal> journal;  ///< may belong to another job
  bool is_this_job = false;              ///< the journal belongs to this job and is undamaged
  /// Foreign files (see foreign_files()), without leftovers of an interrupted run of this job.
  std::vector<std::string> foreign;
};

Contents contents_of(const fs::path& folder, const std::string& job) {
  Contents contents{read_journal(folder), false, {}};
  const std::optional<FolderJournal>& journal = contents.journal;
  contents.is_this_job = journal && journal->job == job && journal->problem.empty();
  contents.foreign = foreign_files(folder, journal.value_or(FolderJournal{}));
  if (contents.is_this_job)
    std::erase_if(contents.foreign, [&](const std::string& name) { return is_unfinished(*journal, name); });
  const bool wrote_report = journal && journal->files.contains(kReport);
  if (is_there(folder / kReport) && !wrote_report && !contents.is_this_job) contents.foreign.emplace_back(kReport);
  return contents;
}

bool is_free(const Contents& contents) {
  if (contents.is_this_job) return true;
  const bool is_empty = !contents.journal || (contents.journal->problem.empty() && !holds_anything(*contents.journal));
  return is_empty && contents.foreign.empty();
}

bool has_other_run(const fs::path& folder, const std::string& job) try {
  require_no_other_run(folder, job);
  return false;
} catch (const Error&) {
  return true;
}

bool is_free(const fs::path& folder, const std::string& job) {
  return is_free(contents_of(folder, job)) && !has_other_run(folder, job);
}

/// Returns, for example, "frame_0000.png and 3 more".
std::string some_of(const std::vector<std::string>& names) {
  return names.size() == 1 ? names.front() : fmt::format("{} and {} more", names.front(), names.size() - 1);
}

Error another_render(const fs::path& folder, const JobDifferences& differences) {
  const std::vector<std::string> keys = differences ? differences(folder / "job.toml") : std::vector<std::string>();
  const std::string what = keys.empty() ? "the scene's files have changed since, or another version of the program rendered it"
                                        : fmt::format("it differs in {}", fmt::join(keys, ", "));
  return Error(folder.string(), "holds another render: " + what,
               fmt::format("{}; `force`, which removes that render's files; the same settings", kAnotherFolder));
}

std::optional<JournalVideo> find_video(const FolderJournal& journal, const std::string& name) {
  const auto found = journal.videos.find(name);
  return found == journal.videos.end() ? std::nullopt : std::optional(found->second);
}

/// The folder of the single view beside a light field (kSingleFolder) may be removed, so its videos are also recorded
/// in the light field's journal.
std::optional<JournalVideo> recorded_video(const fs::path& folder, const Contents& contents, const std::string& video) {
  if (contents.is_this_job)
    if (auto own = find_video(*contents.journal, video_name(folder, video))) return own;
  const fs::path whole = folder_of_whole(folder);
  if (whole.empty()) return std::nullopt;
  return find_video(read_journal(whole).value_or(FolderJournal{}), video_name(whole, video));
}

void require_free_video(const fs::path& folder, const Contents& contents, const std::string& video,
                        const std::vector<int>& frames) {
  if (!is_there(video)) return;
  const std::optional<JournalVideo> recorded = recorded_video(folder, contents, video);
  if (!recorded)
    throw Error(video, fmt::format("exists already, and the render in {} has not written it", folder.string()),
                "another name; `force`, which replaces it");
  const std::vector<int>& shown = recorded->frames;
  if (!std::includes(frames.begin(), frames.end(), shown.begin(), shown.end()))
    throw Error(video,
                fmt::format("is a finished video of frames {}, but this run does not render all of them",
                            write_frames(ranges_of(shown))),
                "all of these frames, with `resume` to keep the finished ones; another name for `video`; `force`, which "
                "replaces the video");
}

/// Removes a file, and its folder of views if that becomes empty. Keeps objects that are not files. Returns whether the name is
/// free now. Throws Error if the file cannot be removed.
bool remove_file(const fs::path& folder, const std::string& name) {
  std::error_code ignored;
  const fs::path file = folder / name, parent = fs::path(name).parent_path();
  if (!parent.empty() && fs::is_symlink(folder / parent, ignored)) return false;
  if (fs::symlink_status(file, ignored).type() == fs::file_type::directory) return false;
  remove_if_there(file);
  if (!parent.empty()) fs::remove(folder / parent, ignored);
  return true;
}

/// Removes the files that a journal records. Keeps videos, job files and reports that have changed since they were
/// recorded.
void remove_files_of(const fs::path& folder, const FolderJournal& journal) {
  for (const auto& [frame, record] : journal.frames)
    for (const auto& [name, sum] : record.files) remove_file(folder, name);
  for (const auto& [frame, strips] : journal.strips) remove_strips(folder, frame, strips.count);
  for (const auto& [name, video] : journal.videos)
    for (const auto& [file, sums] : {std::pair(name, video.sums), std::pair(side_name(name), video.side)})
      if (lies_in_folder(name) && is_as_written(folder / file, sums)) remove_file(folder, file);
  for (const auto& [name, sums] : journal.files)
    if (is_as_written(journal, folder, name)) remove_file(folder, name);
}

/// Removes the files of a web page (kPageFolder), and folders that become empty. Does not follow symbolic links.
void remove_page(const fs::path& folder, const FileRecords& files) {
  std::set<fs::path, std::greater<>> folders;  // inner folders first
  for (const auto& [name, sum] : files) {
    std::error_code ignored;
    bool is_linked = false;
    for (fs::path above = fs::path(name).parent_path(); !above.empty(); above = above.parent_path()) {
      is_linked = is_linked || fs::is_symlink(folder / above, ignored);
      folders.insert(folder / above);
    }
    if (!is_linked && file_checksum(folder / name) == sum) remove_if_there(folder / name);
  }
  std::error_code ignored;
  for (const fs::path& emptied : folders)
    if (!fs::is_symlink(emptied, ignored)) fs::remove(emptied, ignored);
}

void sync_if_there(const fs::path& folder) {
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) platform::sync_folder(folder);
}

/// Syncs the folders of the removed frames, so that the files do not reappear after a power loss.
void sync_removed(const fs::path& folder, const FolderJournal& journal) {
  std::set<fs::path> folders{folder};
  for (const auto& [frame, record] : journal.frames)
    for (const auto& [name, sum] : record.files) folders.insert((folder / name).parent_path());
  for (const fs::path& emptied : folders) sync_if_there(emptied);
}

/// Removes journal files except `own`, and the journal's folder if it becomes empty. The removal is synced, so that old
/// records cannot reappear after a power loss.
void remove_parts(const fs::path& folder, const std::vector<fs::path>& parts, const fs::path& own = {}) {
  for (const fs::path& part : parts)
    if (part != own) remove_if_there(part);
  std::error_code ignored;
  fs::remove(journal_folder(folder), ignored);  // fails if other files remain, which is intended
  for (const fs::path& emptied : {journal_folder(folder), folder}) sync_if_there(emptied);
}

/// Removes the render in kSingleFolder, unless its folder is a symbolic link.
void remove_single(const fs::path& folder) {
  std::error_code ignored;
  if (fs::is_symlink(folder, ignored)) return;
  const std::optional<FolderJournal> journal = read_journal(folder);
  if (!journal) return;
  remove_files_of(folder, *journal);
  sync_removed(folder, *journal);
  remove_parts(folder, journal->parts);
  remove_parts(folder, journal->claims);
  fs::remove(folder, ignored);
}

/// The journal is removed last, so that an interrupted removal can be repeated.
void remove_render(const fs::path& folder, const FolderJournal& journal, const fs::path& own) {
  remove_files_of(folder, journal);
  remove_page(folder, journal.page);
  if (journal.companions.contains(kSingleFolder)) remove_single(folder / kSingleFolder);
  sync_removed(folder, journal);
  remove_parts(folder, journal.parts, own);
}

/// Removes the files of runs of other jobs that have finished no frame or strip. With `force`, also removes the files of
/// another render.
void remove_others(const fs::path& folder, const Contents& contents, const NewRender& render) {
  if (!contents.journal) return;
  for (const fs::path& claim : contents.journal->claims)
    if (claim != render.own) remove_render(folder, read_journal_part(claim), render.own);
  if (contents.is_this_job) return;
  if (!render.force && (holds_anything(*contents.journal) || !contents.journal->problem.empty()))
    throw Error(folder.string(), "another render has started in this folder in the meantime", kAnotherFolder);
  remove_render(folder, *contents.journal, render.own);
}

}  // namespace

fs::path free_folder(const fs::path& wanted, const std::string& job) {
  constexpr int kMost = 10000;
  if (is_free(wanted, job)) return wanted;
  for (int number = 2; number < kMost; ++number) {
    fs::path folder = fmt::format("{}-{}", wanted.string(), number);
    if (is_free(folder, job)) return folder;
  }
  throw Error(wanted.string(), fmt::format("holds another render, and so do {} folders beside it", kMost - 2), kAnotherFolder);
}

void require_free_folder(const fs::path& folder, const std::string& job, const JobDifferences& differences,
                         const std::vector<int>& frames, const std::vector<std::string>& videos) {
  require_regular_files(folder);
  require_no_other_run(folder, job);
  const Contents contents = contents_of(folder, job);
  if (contents.journal && !contents.journal->problem.empty())
    throw Error(journal_folder(folder).string(), "is damaged, or no journal of a render: " + contents.journal->problem,
                fmt::format("the journal without that line; {}; `force`, which removes the files that its other lines name",
                            kAnotherFolder));
  if (!contents.is_this_job && contents.journal && holds_anything(*contents.journal)) throw another_render(folder, differences);
  if (!is_free(contents))
    throw Error(folder.string(),
                fmt::format("holds files of a render, but its journal does not list them: {}", some_of(contents.foreign)),
                fmt::format("{}; `force`, which replaces the files of the rendered frames", kAnotherFolder));
  for (const std::string& video : videos) require_free_video(folder, contents, video, frames);
}

void clear_folder(const fs::path& folder, const NewRender& render, const Context& context) {
  require_regular_files(folder);
  require_no_other_run(folder, render.job);
  remove_others(folder, contents_of(folder, render.job), render);
  Contents contents = contents_of(folder, render.job);
  const auto is_in_the_way = [&](const std::string& name) {
    return name == kReport || std::binary_search(render.frames.begin(), render.frames.end(), frame_of_file(name).value_or(-1));
  };
  if (render.force)
    std::erase_if(contents.foreign, [&](const std::string& name) { return is_in_the_way(name) && remove_file(folder, name); });
  if (!contents.foreign.empty())
    context.warning(fmt::format("{} also holds files that do not belong to this render and are kept: {}", folder.string(),
                                some_of(contents.foreign)));
}

void require_no_render(const fs::path& out) {
  const auto names = [&](const FolderJournal& journal) {
    const std::string name = out.filename().string();
    const auto frame = journal.frames.find(frame_of_file(name).value_or(-1));
    return journal.videos.contains(name) || (frame != journal.frames.end() && frame->second.files.contains(name));
  };
  require_no_other_run(out, {});
  if (const auto journal = read_journal(out); journal && holds_anything(*journal))
    throw Error(out.string(), "holds a render, whose frames would be mixed with the new pictures", "another folder");
  if (const auto journal = read_journal(out.parent_path()); journal && names(*journal))
    throw Error(out.string(), "would overwrite a file of the render in this folder", "another name");
}

}  // namespace lippmann
