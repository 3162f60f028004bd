// The folder of a render during a run. Finds the frames that earlier runs of the job have finished, and writes the
// run's journal file (folder/journal.hpp). Any number of runs of one job may use a folder at the same time. No run
// changes the files of another one, except job.toml and report.json, which every run rewrites so that they cover all
// runs.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "folder/journal.hpp"
#include "folder/journal_part.hpp"

namespace lippmann {

class RenderFolder {
 public:
  /// Clears the folder, but keeps this run's journal file `own`.
  using MakeRoom = std::function<void(const std::filesystem::path& own)>;

  /// Begins a run's journal in the existing `folder`. From then on, runs of other jobs are refused there. Throws Error
  /// if the folder belongs to another job and `make_room` does not clear it (folder/claim_folder.hpp), if a run of
  /// another job is active, or if the journal is damaged or cannot be written.
  RenderFolder(std::filesystem::path folder, const std::string& job, const MakeRoom& make_room = {});

  const std::filesystem::path& path() const { return folder_; }

  /// Renews the run's lease, at least every kLeaseSeconds. Thread-safe.
  void renew() const { part_.renew(); }

  /// The journal before this run.
  const FolderJournal& before() const { return before_; }

  /// The current journal, with the records of this run and of parallel runs.
  FolderJournal now() const;

  /// Returns the report of a frame that an earlier run has finished, or nullopt if it is unfinished or one of its files
  /// is missing or differs from its record. Reads a frame's files only on the first call.
  std::optional<FrameReport> find(int frame);

  /// Records the frames and companions (FolderJournal::companions) that the run will render.
  void begin(const std::vector<int>& frames, const std::set<std::string>& companions = {}) {
    part_.add(asked_line(frames, companions));
  }

  /// Records a frame whose files are complete. find() does not return frames of this run. May be called in parallel with
  /// find(), but not with other functions that record.
  void add(const FrameReport& frame, const FileRecords& files) { part_.add(frame_line(frame, files)); }

  /// Records a strip whose file is complete. May be called in parallel with find(), but not with other functions that
  /// record.
  void add_strip(const StripNumber& strip, const FrameReport& report, const FileRecords& files) {
    part_.add(strip_line(strip, report, files));
  }

  /// Writes job.toml or report.json with the text that `text_of` makes from the journal, and writes the file again if the
  /// journal has changed meanwhile. Thus, if several runs end at the same time, the last file includes the records of all runs.
  void write(const std::string& name, const std::function<std::string(const FolderJournal&)>& text_of);

  /// Records that a video of `frames` is about to be written, so that it belongs to this render.
  void begin_video(const std::filesystem::path& video, const std::vector<int>& frames);

  void add_video(const std::filesystem::path& video, const std::vector<int>& frames, bool has_side_file = false);

  void add_page(const std::vector<std::filesystem::path>& files) { part_.add(page_line(records_of(folder_, files))); }

  void end(const RunReport& run) { part_.add(run_line(run)); }

 private:
  std::filesystem::path folder_;
  JournalPart part_;
  FolderJournal before_;
  std::map<int, bool> is_as_recorded_;  ///< results of find(), by frame
};

/// Throws Error if a run of another job is active in `folder`. Changes nothing.
void require_no_other_run(const std::filesystem::path& folder, const std::string& job);

/// Returns the folder of the light field if `folder` is its kSingleFolder (a render of a single view), otherwise an
/// empty path.
std::filesystem::path folder_of_whole(const std::filesystem::path& folder);

/// Path of a video relative to the folder, as the journal stores it.
std::string video_name(const std::filesystem::path& folder, const std::filesystem::path& video);

}  // namespace lippmann
