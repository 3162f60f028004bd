// Selects the parts of a job that one run makes: all, or some frames or strips while other runs make the rest.
#pragma once

#include <optional>
#include <vector>

#include "core/frame_ranges.hpp"
#include "distribute/ranks.hpp"
#include "distribute/units.hpp"
#include "job/resolved_job.hpp"

namespace lippmann {

/// Parameters of one run of a job.
struct RunParams {
  bool force = false;  ///< replace another render in the folder, and existing videos (folder/claim_folder.hpp)
  /// Units of the job to render; nullopt: all frames. With units, finish_animation makes the videos afterwards.
  std::optional<Units> units = {};
  std::optional<FrameRanges> only_frames = {};  ///< frames to render, out of those of the job or units; nullopt: all of them
  /// Parts to render (parts_of), instead of those that `units` and `only_frames` select.
  std::optional<std::vector<int>> parts = {};
  Ranks* ranks = nullptr;                       ///< the processes that share the frames; null: this process renders all
  bool only_finished = false;                   ///< render nothing; a missing frame is an Error
  std::optional<double> available_memory = {};  ///< bytes; nullopt: the memory of this machine (core/platform.hpp)

  /// Returns whether other runs render some parts of the job.
  bool is_part() const { return units || only_frames || parts; }

  /// Returns whether this process reports for the run.
  bool is_first_rank() const { return !ranks || ranks->rank() == 0; }
};

/// The parts that a run makes. A part is a frame or, if the job is rendered in strips, a strip with the number frame * strips +
/// strip.
struct RunParts {
  int strips = 1;           ///< strips per frame
  int segment = 1;          ///< units begin at multiples of this number of frames (frames_per_segment)
  std::vector<int> of_job;  ///< all frames of the job
  std::vector<int> parts;   ///< parts of this run, ascending
  std::vector<int> frames;  ///< frames that `parts` belong to

  /// Throws a usage Error for frames outside the animation, and if `run` selects no frame.
  RunParts(const ResolvedJob& job, const FrameParams& frame_settings, const Timeline& timeline, const RunParams& run);
};

/// Returns RunParts::segment. The result is 1 for frames that are rendered in strips, which may be cut into units anywhere.
int segment_of(const ResolvedJob& job, const FrameParams& frame_settings);

}  // namespace lippmann
