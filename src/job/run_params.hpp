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
  bool force = false;               ///< replace another render in the folder, and existing videos (folder/claim_folder.hpp)
  std::optional<Units> units = {};  ///< nullopt: all frames. finish_animation makes the videos after all units
  std::optional<FrameRanges> only_frames = {};  ///< renders only these; the job or units still include the others
  std::optional<std::vector<int>> parts = {};   ///< renders these parts (parts_of), overriding the two above
  Ranks* ranks = nullptr;                       ///< processes that share the frames; null: a single process
  bool only_finished = false;                   ///< render nothing; a missing frame is an Error
  std::optional<double> available_memory = {};  ///< bytes; nullopt: the memory of this machine (core/platform.hpp)

  /// Returns whether other runs render the rest of the job.
  bool is_part() const { return units || only_frames || parts; }

  /// Returns whether this process reports for the run.
  bool is_first_rank() const { return !ranks || ranks->rank() == 0; }
};

/// Parts are frames, or strips of frames if the job is rendered in strips: frame * strips + strip.
struct RunParts {
  int strips = 1;           ///< strips per frame
  int segment = 1;          ///< units begin at multiples of this (frames_per_segment)
  std::vector<int> of_job;  ///< all frames of the job
  std::vector<int> parts;   ///< parts of this run, ascending
  std::vector<int> frames;  ///< frames of these parts

  /// Throws a usage Error for frames outside the animation, and if `run` selects none.
  RunParts(const ResolvedJob& job, const FrameParams& frame_settings, const Timeline& timeline, const RunParams& run);
};

/// Returns RunParts::segment: 1 if frames are rendered in strips, which may be cut into units anywhere.
int segment_of(const ResolvedJob& job, const FrameParams& frame_settings);

}  // namespace lippmann
