// What a run does with the folder of its job, whatever makes the frames and writes their files: a render does it, and so does
// the simulation of renders that are killed (tests/simulation).
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "folder/render_folder.hpp"
#include "job/params.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

/// Makes the folder and room in it (folder/claim_folder.hpp), begins the run's journal with `frames`, which are all of the job,
/// and writes job.toml. `frame_count`: of the scene's animation. Throws Error as clear_folder and RenderFolder do.
RenderFolder open_job_folder(const std::filesystem::path& path, const std::string& job, const RenderParams& params,
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

}  // namespace lippmann
