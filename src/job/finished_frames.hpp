// Which frames in an output folder a job has finished: what --resume goes by. Kept in the folder's journal
// (folder_journal.hpp).
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "job/folder_journal.hpp"
#include "job/frame_files.hpp"
#include "job/params.hpp"
#include "job/report.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Tells jobs apart by all that decides the pictures: the parameters that change them, the scene, the display, this program's
/// version.
std::string job_fingerprint(const RenderParams& params, const Scene& scene, const Display* display = nullptr);

class FinishedFrames {
 public:
  /// Opens the journal of `folder`, which exists, or begins one. Throws Error if the folder is that of another job
  /// (render_folder.hpp makes room), or the journal is damaged or cannot be written.
  FinishedFrames(std::filesystem::path folder, const std::string& job, FrameNames names);

  /// What earlier runs of this job were to render, and wrote beside the frames.
  const FolderJournal& before() const { return before_; }

  /// The figures of a frame that an earlier run finished; none if it has yet to be rendered, or one of its files is not there
  /// with the recorded bytes. Reads the files, once.
  std::optional<FrameReport> find(int frame);

  /// Records that a run begins.
  void begin(const std::vector<int>& frames) { write(asked_line(frames)); }

  /// Records a frame whose files are complete; find() does not see it. May run beside find(), and not beside what else records.
  void add(const FrameReport& frame, const FileRecords& files) { write(frame_line(frame, files)); }

  /// Records job.toml or report.json, which is complete.
  void add_file(const std::string& name);

  /// Removes such a file.
  void remove_file(const std::string& name);

  /// Records that a video of these frames is about to appear: from then on it is this render's.
  void begin_video(const std::filesystem::path& video, const std::vector<int>& frames);

  /// Records a video, which is complete and shows these frames.
  void add_video(const std::filesystem::path& video, const std::vector<int>& frames);

 private:
  /// All that record throw Error if the journal cannot be written.
  void write(const std::string& line);

  std::filesystem::path folder_, path_;
  FrameNames names_;
  FolderJournal before_;
  std::map<int, bool> is_as_recorded_;  ///< what find() has read
  std::ofstream out_;
};

}  // namespace lippmann
