// Which parts of a job one run makes: all of it, or some frames or strips while others make the rest.
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
  bool force = false;  ///< another render in the folder is replaced, and videos that are there (folder/claim_folder.hpp)
  std::optional<Units> units = {};              ///< none: all frames. Videos wait until all are there (finish_animation)
  std::optional<FrameRanges> only_frames = {};  ///< renders these alone; the job's or units' others are asked for all the same
  std::optional<std::vector<int>> parts = {};   ///< renders these parts (parts_of), whatever the two above say
  Ranks* ranks = nullptr;                       ///< that share the frames out among them; null: this process stands alone
  bool only_finished = false;                   ///< no frame is rendered: all have been, or it is an Error
  std::optional<double> available_memory = {};  ///< bytes; none: what this machine has (core/platform.hpp)

  /// Whether other runs render the rest of the job.
  bool is_part() const { return units || only_frames || parts; }

  /// Whether this process speaks for the run.
  bool is_first_rank() const { return !ranks || ranks->rank() == 0; }
};

/// Parts are frames, or strips of them where the job is rendered in strips: frame * strips + strip.
struct RunParts {
  int strips = 1;           ///< of each frame
  int segment = 1;          ///< parts are cut into units before multiples of this only (frames_per_segment)
  std::vector<int> of_job;  ///< all frames of the job
  std::vector<int> parts;   ///< this run's, ascending
  std::vector<int> frames;  ///< that these belong to

  /// Throws a usage Error for frames outside the animation, and where `run` selects none.
  RunParts(const ResolvedJob& job, const FrameParams& made_as, const Timeline& timeline, const RunParams& run);
};

/// Returns RunParts::segment: 1 if frames are rendered in strips, which may be cut into units anywhere.
int segment_of(const ResolvedJob& job, const FrameParams& made_as);

}  // namespace lippmann
