// Estimates the cost of a job's frames from a few that were rendered as a measurement.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "lippmann/frames/frame_report.hpp"

namespace lippmann {

/// CPU times are sums over all threads.
struct JobCosts {
  double setup_cpu_seconds = 0.0;  ///< loading and building, once per unit
  std::map<int, double> at;  ///< cost of a frame by its position in its segment (from 0); an entry holds until the next one
  double write_cpu_seconds = 0.0;       ///< writing the files of a frame
  double source_cpu_seconds = 0.0;      ///< all frames that a unit renders besides its own
  std::uint64_t peak_memory_bytes = 0;  ///< peak of the measuring process
  std::vector<int> frames;              ///< frames of which all or some strips were measured
};

/// A run of a few frames of a job.
struct MeasuredRun {
  std::vector<FrameReport> frames, sources;
  double setup_cpu_seconds = 0.0;
  double cpu_seconds = 0.0;  ///< of the whole process, from the start of set-up until all files were written
  std::uint64_t peak_memory_bytes = 0;
};

/// The frames to measure in each segment.
enum class Neighbours {
  kOthers,  ///< all frames of a segment after its first cost about the same; two are measured
  kCopied,  ///< the same, for segments that may be single frames with copies
};

/// Chooses frames of the first, the middle and the last segment.
std::vector<int> frames_to_measure(const std::vector<int>& of_job, int segment, Neighbours neighbours);

JobCosts frame_costs(const MeasuredRun& run, const std::vector<int>& of_job, int segment);

/// Returns the CPU seconds of a run of these frames.
double cpu_seconds_of(const std::vector<int>& frames, int segment, const JobCosts& costs);

}  // namespace lippmann
