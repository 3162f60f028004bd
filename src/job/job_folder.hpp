// What a run does with the folder of its job, whatever makes the frames and writes their files: a render does it, and so does
// the simulation of renders that are killed (tests/simulation).
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

/// Makes the folder, begins the run's journal there, makes room (folder/claim_folder.hpp), records `frames`, which are all of
/// the job, and writes job.toml. `frame_count`: of the scene's animation. Throws Error as clear_folder and RenderFolder do.
RenderFolder open_job_folder(const std::filesystem::path& path, const std::string& fingerprint, const ResolvedJob& job,
                             const std::vector<int>& frames, int frame_count, bool force, const Context& context);

/// What the tool is called with to go on with the render of a folder, in silence.
std::vector<std::string> words_to_resume(const std::filesystem::path& folder);

/// What becomes of each frame.
struct FrameSteps {
  bool keeps_finished = false;  ///< what is there as it was recorded is not made again
  bool only_finished = false;   ///< nothing is made: a frame that is not there is an Error
  std::function<void(const FrameReport&)> keep;
  std::function<bool(int)> make;  ///< false: was stopped
};

/// In order, until one is stopped.
void take_frames(const std::vector<int>& frames, RenderFolder& folder, const FrameSteps& steps);

/// What becomes of each strip.
struct StripSteps {
  int count = 1;                ///< that a frame has
  bool keeps_finished = false;  ///< what is there as it was recorded is not made again, nor strips of frames that are there
  std::function<bool(int frame, int strip)> make;  ///< false: was stopped
};

/// The parts of frames that are cut into so many strips: frame * count + strip of each, for frames that ascend. Throws a usage
/// Error where that is more than a number holds.
std::vector<int> parts_of(const std::vector<int>& frames, int count);

/// The frames of such parts, each once, ascending.
std::vector<int> frames_of_parts(const std::vector<int>& parts, int count);

/// Their strips, by frame.
std::map<int, std::vector<int>> strips_of_parts(const std::vector<int>& parts, int count);

/// Whether a part, or all of its frame, is there as `journal` records it. Reads the files.
bool is_finished_part(int part, int count, RenderFolder& folder, const FolderJournal& journal);

/// Parts in order, until one is stopped.
void take_strips(const std::vector<int>& parts, RenderFolder& folder, const StripSteps& steps);

/// Figures of the strips of a frame, from the top. Throws Error naming the first that is not finished, or not as it was
/// written.
std::vector<FrameReport> finished_strips(const RenderFolder& folder, int frame, int count);

}  // namespace lippmann
