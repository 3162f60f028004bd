// Estimates the cost of a job's frames from a few rendered frames. A job is divided into units, which different runs render.
// Frames that are made together form a segment. The frames of a segment are always in one unit.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "lippmann/frames/frame_report.hpp"

namespace lippmann {

/// CPU times are sums over all threads.
struct JobCosts {
  /// CPU time for loading the scene and building its acceleration structures, which each unit does once.
  double setup_cpu_seconds = 0.0;
  /// CPU time of a frame by its position in its segment. If a position is missing, the nearest lower position applies.
  std::map<int, double> at;
  double write_cpu_seconds = 0.0;  ///< writing the files of one frame
  /// CPU time of a unit's source frames. The unit renders these frames of other units to make its own frames from them.
  double source_cpu_seconds = 0.0;
  std::uint64_t peak_memory_bytes = 0;  ///< peak memory of the process that measured the costs
  std::vector<int> frames;              ///< measured frames, including frames of which only some strips were rendered
};

struct MeasuredRun {
  std::vector<FrameReport> frames, sources;
  double setup_cpu_seconds = 0.0;
  /// CPU time of the whole process, from the start of the set-up until all files were written.
  double cpu_seconds = 0.0;
  std::uint64_t peak_memory_bytes = 0;
};

/// How the frames of a segment depend on each other, which decides how many are measured.
enum class Neighbours {
  /// After the first one, all frames of a segment cost about the same. The first two are measured.
  kOthers,
  /// Frames may be copied from the frame before, also across segments. Two consecutive frames are measured.
  kCopied,
};

/// Returns frames of the first, the middle and the last segment.
std::vector<int> frames_to_measure(const std::vector<int>& of_job, int segment, Neighbours neighbours);

JobCosts frame_costs(const MeasuredRun& run, const std::vector<int>& of_job, int segment);

double cpu_seconds_of(const std::vector<int>& frames, int segment, const JobCosts& costs);

}  // namespace lippmann
