// Operations of a run on the folder of its job. They do not depend on how frames are made and written. Renders use them, and so
// does the simulation of killed renders (tests/simulation).
//
// A job can be rendered in strips, which are rows of a frame. Strips are numbered through all frames: strip s of frame f is
// part f * (strips per frame) + s.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "folder/render_folder.hpp"
#include "job/resolved_job.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

/// Makes the folder and begins the run's journal. Removes old files (folder/claim_folder.hpp), records `frames` (all frames of
/// the job) and writes job.toml. `frame_count` is the length of the scene's animation. Throws Error like clear_folder() and
/// RenderFolder.
RenderFolder open_job_folder(const std::filesystem::path& path, const std::string& fingerprint, const ResolvedJob& job,
                             const std::vector<int>& frames, int frame_count, bool force, const Context& context);

/// Returns the words of a command that resumes the render of a folder without progress messages.
std::vector<std::string> words_to_resume(const std::filesystem::path& folder);

struct FrameSteps {
  bool keeps_finished = false;  ///< if true, frames whose files match the journal are kept
  bool only_finished = false;   ///< if true, no frame is made, and a missing frame is an Error
  std::function<void(const FrameReport&)> keep;
  std::function<bool(int)> make;  ///< returns false if cancelled
};

/// Calls `keep` or `make` for each frame, in order. Stops if `make` returns false.
void take_frames(const std::vector<int>& frames, RenderFolder& folder, const FrameSteps& steps);

struct StripSteps {
  int count = 1;  ///< number of strips per frame
  /// If true, strips whose files match the journal are kept, and all strips of finished frames are skipped.
  bool keeps_finished = false;
  std::function<bool(int frame, int strip)> make;  ///< returns false if cancelled
};

/// Returns the part numbers of all strips of `frames`, which must ascend: frame * count + strip. `count` is the number of
/// strips per frame. Throws a usage Error if a part number overflows.
std::vector<int> parts_of(const std::vector<int>& frames, int count);

/// Returns the frames that `parts` belong to, in ascending order and without duplicates. `count` is the number of strips per
/// frame.
std::vector<int> frames_of_parts(const std::vector<int>& parts, int count);

/// Returns the strip numbers in `parts`, for each frame. `count` is the number of strips per frame.
std::map<int, std::vector<int>> strips_of_parts(const std::vector<int>& parts, int count);

/// Returns whether the files of a part exist as recorded in `journal`. Also returns true if the files of its whole frame exist.
/// Reads the files. `count` is the number of strips per frame.
bool is_finished_part(int part, int count, RenderFolder& folder, const FolderJournal& journal);

/// Calls `make` for the missing strips, in order. Skips strips that exist if keeps_finished is set. Stops if `make` returns
/// false.
void take_strips(const std::vector<int>& parts, RenderFolder& folder, const StripSteps& steps);

/// Returns the reports of a frame's strips, from top to bottom. Throws Error that names the first strip that is missing or
/// differs from the journal.
std::vector<FrameReport> finished_strips(const RenderFolder& folder, int frame, int count);

}  // namespace lippmann
