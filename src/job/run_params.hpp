// Selects what one run renders of a job: everything, or some frames or strips while other runs render the rest.
#pragma once

#include <optional>
#include <vector>

#include "core/frame_ranges.hpp"
#include "distribute/ranks.hpp"
#include "distribute/units.hpp"
#include "job/resolved_job.hpp"

namespace lippmann {

/// A unit is a set of frames or strips that one run renders.
struct RunParams {
  /// Replaces another render in the folder, and existing videos (folder/claim_folder.hpp).
  bool force = false;
  /// Units of the job to render; nullopt: all frames. If a job is rendered in units, finish_animation() makes its videos.
  std::optional<Units> units = {};
  /// Renders only these frames of the job or of `units`; nullopt: all frames.
  std::optional<FrameRanges> only_frames = {};
  /// Renders these parts (see RunParts), instead of the parts that `units` and `only_frames` select.
  std::optional<std::vector<int>> parts = {};
  /// The processes that share the frames; null: this process renders all frames.
  Ranks* ranks = nullptr;
  bool only_finished = false;  ///< renders nothing; a missing frame is an Error
  /// Available memory in bytes; nullopt: the memory of this machine (core/platform.hpp).
  std::optional<double> available_memory = {};

  /// Returns whether other runs render the rest of the job.
  bool is_part() const { return units || only_frames || parts; }

  /// Returns whether this process reports the results of the run.
  bool is_first_rank() const { return !ranks || ranks->rank() == 0; }
};

/// The parts of a job that a run makes: frames or, if the job is rendered in strips, strips with the numbers frame *
/// strips + strip.
struct RunParts {
  int strips = 1;
  /// Number of successive frames in a segment (frames_per_segment()). The frames of a segment are always in the same unit.
  int segment = 1;
  std::vector<int> of_job;
  std::vector<int> parts;   ///< parts of this run, in ascending order
  std::vector<int> frames;  ///< frames of `parts`, in ascending order

  /// Throws a usage Error for frames outside the animation, and if `run` selects no frame.
  RunParts(const ResolvedJob& job, const FrameParams& frame_settings, const Timeline& timeline, const RunParams& run);
};

/// Returns RunParts::segment, which is 1 for frames in strips.
int segment_of(const ResolvedJob& job, const FrameParams& frame_settings);

}  // namespace lippmann
