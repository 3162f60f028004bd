// The folder of a render while a run works in it: what earlier runs of the job have finished, which --resume keeps, and the
// run's own lines of the journal (folder/journal.hpp).
//
// Any number of runs of one job may work in one folder at a time: none changes what another has written, but for job.toml and
// report.json, which every run writes for all of them.
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
  /// Makes room in the folder, whose journal has a file of this run now: the one file that has to stay.
  using MakeRoom = std::function<void(const std::filesystem::path& own)>;

  /// Begins a run's journal in `folder`, which exists; from then on no run of another job begins there. Throws Error if the
  /// folder is that of another job and `make_room` does not change that (folder/claim_folder.hpp), if a run of another job goes
  /// on there, or if its journal is damaged or cannot be written.
  RenderFolder(std::filesystem::path folder, const std::string& job, const MakeRoom& make_room = {});

  const std::filesystem::path& path() const { return folder_; }

  /// Says that the run goes on, which must be done more often than every kLeaseSeconds. May run beside all else.
  void renew() const { part_.renew(); }

  /// What earlier runs of this job were to render, and wrote.
  const FolderJournal& before() const { return before_; }

  /// The same now, with what this run and those beside it have recorded since.
  FolderJournal now() const;

  /// The figures of a frame that an earlier run finished; none if it has yet to be rendered, or one of its files is not there
  /// with the recorded bytes. Reads the files, once.
  std::optional<FrameReport> find(int frame);

  /// Records which frames the run is to render, and which folders beside them (FolderJournal::companions).
  void begin(const std::vector<int>& frames, const std::set<std::string>& companions = {}) {
    part_.add(asked_line(frames, companions));
  }

  /// Records a frame whose files are complete; find() does not see it. May run beside find(), and not beside what else records.
  void add(const FrameReport& frame, const FileRecords& files) { part_.add(frame_line(frame, files)); }

  /// Records a strip whose file is complete. As add().
  void add_strip(const StripNumber& strip, const FrameReport& report, const FileRecords& files) {
    part_.add(strip_line(strip, report, files));
  }

  /// Writes job.toml or report.json as `text_of` says it of the journal, again if the journal tells it otherwise once it is
  /// written: of several runs that end at the same time, the last one to write has seen what all have recorded.
  void write(const std::string& name, const std::function<std::string(const FolderJournal&)>& text_of);

  /// Records that a video of these frames is about to appear: from then on it is this render's.
  void begin_video(const std::filesystem::path& video, const std::vector<int>& frames);

  /// Records a video, which is complete and shows these frames, and its side file if it has one.
  void add_video(const std::filesystem::path& video, const std::vector<int>& frames, bool has_side_file = false);

  /// Records files of the page, which are complete and lie in this folder.
  void add_page(const std::vector<std::filesystem::path>& files) { part_.add(page_line(records_of(folder_, files))); }

  /// Records what the run took.
  void end(const RunReport& run) { part_.add(run_line(run)); }

 private:
  std::filesystem::path folder_;
  JournalPart part_;
  FolderJournal before_;
  std::map<int, bool> is_as_recorded_;  ///< what find() has read
};

/// Throws Error if a run of another job goes on in `folder`. Changes nothing.
void require_no_other_run(const std::filesystem::path& folder, const std::string& job);

/// The folder of the render that wrote `folder` beside its frames (kSingleFolder); empty: there is none.
std::filesystem::path folder_of_whole(const std::filesystem::path& folder);

/// A video's path relative to the folder, as the journal has it.
std::string video_name(const std::filesystem::path& folder, const std::filesystem::path& video);

}  // namespace lippmann
