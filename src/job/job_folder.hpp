// The operations of a run on its job's folder, independent of how frames are made and written. Renders use them, and so does
// the simulation of killed renders (tests/simulation).
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

/// Makes the folder, begins the run's journal, clears old files (folder/claim_folder.hpp), records `frames` (all frames of the
/// job) and writes job.toml. `frame_count` is the length of the scene's animation. Throws Error as clear_folder and
/// RenderFolder do.
RenderFolder open_job_folder(const std::filesystem::path& path, const std::string& fingerprint, const ResolvedJob& job,
                             const std::vector<int>& frames, int frame_count, bool force, const Context& context);

/// Returns the command-line words that resume the render of a folder without progress messages.
std::vector<std::string> words_to_resume(const std::filesystem::path& folder);

/// The steps of take_frames().
struct FrameSteps {
  bool keeps_finished = false;  ///< keep parts whose files match the record
  bool only_finished = false;   ///< make nothing; a missing frame is an Error
  std::function<void(const FrameReport&)> keep;
  std::function<bool(int)> make;  ///< returns false if cancelled
};

/// Keeps or makes the frames in order. Stops if a step is cancelled.
void take_frames(const std::vector<int>& frames, RenderFolder& folder, const FrameSteps& steps);

/// The steps of take_strips().
struct StripSteps {
  int count = 1;                ///< strips per frame
  bool keeps_finished = false;  ///< keep strips whose files match the record, and skip those of finished frames
  std::function<bool(int frame, int strip)> make;  ///< returns false if cancelled
};

/// Returns the parts of frames cut into `count` strips: frame * count + strip for each. `frames` ascend. Throws a usage Error
/// if a part's number overflows.
std::vector<int> parts_of(const std::vector<int>& frames, int count);

/// Returns the frames that the parts belong to, without duplicates, ascending. `parts` and `count` are as in parts_of().
std::vector<int> frames_of_parts(const std::vector<int>& parts, int count);

/// Returns the strips of each frame in `parts`.
std::map<int, std::vector<int>> strips_of_parts(const std::vector<int>& parts, int count);

/// Returns whether the part, or the whole frame that it belongs to, exists as recorded in `journal`. Reads the files.
bool is_finished_part(int part, int count, RenderFolder& folder, const FolderJournal& journal);

/// Keeps or makes the strips in order. Stops if a step is cancelled.
void take_strips(const std::vector<int>& parts, RenderFolder& folder, const StripSteps& steps);

/// Returns the figures of a frame's strips, from top to bottom. Throws Error naming the first strip that is missing or differs
/// from its record.
std::vector<FrameReport> finished_strips(const RenderFolder& folder, int frame, int count);

}  // namespace lippmann
