// Operations of a run on the folder of its job, which do not depend on how frames are made. Strips are rows of a frame,
// numbered through all frames: strip s of frame f is part f * (strips per frame) + s.
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

/// Makes the folder, begins the run's journal, removes old files (folder/claim_folder.hpp) and writes job.toml.
/// `frames`: all frames of the job. `frame_count`: length of the scene's animation. Throws Error like clear_folder()
/// and RenderFolder.
RenderFolder open_job_folder(const std::filesystem::path& path, const std::string& fingerprint, const ResolvedJob& job,
                             const std::vector<int>& frames, int frame_count, bool force, const Context& context);

/// Returns the words of a command that resumes the render of a folder without progress messages.
std::vector<std::string> words_to_resume(const std::filesystem::path& folder);

struct FrameSteps {
  bool keeps_finished = false;  ///< keeps frames whose files match the journal
  bool only_finished = false;   ///< makes no frame; a missing frame is an Error
  std::function<void(const FrameReport&)> keep;
  std::function<bool(int)> make;  ///< returns false if cancelled
};

/// Calls `keep` or `make` for each frame, in order. Stops if `make` returns false.
void take_frames(const std::vector<int>& frames, RenderFolder& folder, const FrameSteps& steps);

struct StripSteps {
  int count = 1;  ///< strips per frame
  /// Keeps strips whose files match the journal, and skips all strips of finished frames.
  bool keeps_finished = false;
  std::function<bool(int frame, int strip)> make;  ///< returns false if cancelled
};

/// Returns the part numbers, frame * count + strip, of all strips of `frames`, which must ascend. `count`: strips per
/// frame. Throws a usage Error if a part number overflows.
std::vector<int> parts_of(const std::vector<int>& frames, int count);

/// Returns the frames of `parts`, ascending and without duplicates. `count`: strips per frame.
std::vector<int> frames_of_parts(const std::vector<int>& parts, int count);

/// Returns the strip numbers in `parts` by frame. `count`: strips per frame.
std::map<int, std::vector<int>> strips_of_parts(const std::vector<int>& parts, int count);

/// Reads the files of a part, or of its whole frame, and returns whether they match `journal`. `count`: strips per
/// frame.
bool is_finished_part(int part, int count, RenderFolder& folder, const FolderJournal& journal);

/// Calls `make` for the missing strips, in order. Stops if `make` returns false.
void take_strips(const std::vector<int>& parts, RenderFolder& folder, const StripSteps& steps);

/// Returns the reports of a frame's strips, from top to bottom. Throws Error that names the first strip that is missing
/// or differs from the journal.
std::vector<FrameReport> finished_strips(const RenderFolder& folder, int frame, int count);

}  // namespace lippmann
