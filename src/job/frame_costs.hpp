// Estimates the cost of a job's frames from a few that were rendered as a measurement.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "lippmann/frames/frame_report.hpp"

namespace lippmann {

/// Costs of the steps of a job. CPU times are sums over all threads.
struct JobCosts {
  double setup_cpu_seconds = 0.0;  ///< loading the scene and building its structures, once per unit
  std::map<int, double> at;  ///< cost of a frame by its position in its segment (from 0); an entry holds until the next one
  double write_cpu_seconds = 0.0;       ///< writing the files of a frame
  double source_cpu_seconds = 0.0;      ///< all source frames that a unit renders besides its own frames
  std::uint64_t peak_memory_bytes = 0;  ///< peak memory of the measuring process
  std::vector<int> frames;              ///< frames of which all or some strips were measured
};

/// A run of a few frames of a job.
struct MeasuredRun {
  std::vector<FrameReport> frames, sources;
  double setup_cpu_seconds = 0.0;
  double cpu_seconds = 0.0;  ///< CPU time of the whole process, from the start of set-up until all files were written
  std::uint64_t peak_memory_bytes = 0;
};

/// How the frames of a segment depend on each other, which decides how many are measured.
enum class Neighbours {
  kOthers,  ///< all frames of a segment after the first cost about the same, so two frames per segment are measured
  kCopied,  ///< frames may be copies of other frames even if segments are single frames, so two consecutive frames are measured
};

/// Chooses the frames to measure from the first, the middle and the last segment.
std::vector<int> frames_to_measure(const std::vector<int>& of_job, int segment, Neighbours neighbours);

JobCosts frame_costs(const MeasuredRun& run, const std::vector<int>& of_job, int segment);

/// Estimates the CPU seconds of a run that renders these frames.
double cpu_seconds_of(const std::vector<int>& frames, int segment, const JobCosts& costs);

}  // namespace lippmann
