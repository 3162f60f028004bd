// Selects what one run renders of a job: everything, or some frames or strips while other runs render the rest.
#pragma once

#include <optional>
#include <vector>

#include "core/frame_ranges.hpp"
#include "distribute/ranks.hpp"
#include "distribute/units.hpp"
#include "job/resolved_job.hpp"

namespace lippmann {

/// Parameters of one run of a job. A unit is a set of frames or strips that one run renders.
struct RunParams {
  /// Whether to replace another render in the folder, and existing videos (folder/claim_folder.hpp).
  bool force = false;
  /// Units of the job to render. If nullopt, all frames are rendered. With units, finish_animation() makes the videos later.
  std::optional<Units> units = {};
  /// Frames to render. Other frames of the job or of `units` are left out. If nullopt, no frame is left out.
  std::optional<FrameRanges> only_frames = {};
  /// Parts to render (see RunParts). They replace the parts that `units` and `only_frames` select.
  std::optional<std::vector<int>> parts = {};
  /// The processes that share the frames. If null, this process renders all frames.
  Ranks* ranks = nullptr;
  bool only_finished = false;  ///< if true, nothing is rendered, and a missing frame is an Error
  /// Available memory in bytes. If nullopt, the memory of this machine (core/platform.hpp).
  std::optional<double> available_memory = {};

  /// Returns whether other runs render some parts of the job.
  bool is_part() const { return units || only_frames || parts; }

  /// Returns whether this process reports the results of the run.
  bool is_first_rank() const { return !ranks || ranks->rank() == 0; }
};

/// The parts of a job that a run makes. Normally, a part is a frame. If the job is rendered in strips, a part is a strip, and
/// its number is frame * strips + strip.
struct RunParts {
  int strips = 1;
  /// Units begin at frames that are multiples of this number (frames_per_segment).
  int segment = 1;
  std::vector<int> of_job;
  std::vector<int> parts;   ///< parts of this run, in ascending order
  std::vector<int> frames;  ///< frames that `parts` belong to

  /// Throws a usage Error for frames outside the animation, and if `run` selects no frame.
  RunParts(const ResolvedJob& job, const FrameParams& frame_settings, const Timeline& timeline, const RunParams& run);
};

/// Returns RunParts::segment. It is 1 for frames in strips, because units may begin at any strip.
int segment_of(const ResolvedJob& job, const FrameParams& frame_settings);

}  // namespace lippmann
