// What the frames of a job are likely to take, from a few that were rendered to find out.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "lippmann/frames/frame_report.hpp"

namespace lippmann {

/// CPU times are those of all threads together.
struct JobCosts {
  double setup_cpu_seconds = 0.0;       ///< for loading and building, which every unit pays
  std::map<int, double> at;             ///< for a frame of this place in its segment (from 0), or up to the next entry's
  double write_cpu_seconds = 0.0;       ///< for the files of a frame
  double source_cpu_seconds = 0.0;      ///< for all frames that a unit renders beside its own
  std::uint64_t peak_memory_bytes = 0;  ///< the most that the measuring process has held
  std::vector<int> frames;              ///< that were measured, or that strips were measured of
};

/// A run of a few frames of a job.
struct MeasuredRun {
  std::vector<FrameReport> frames, sources;
  double setup_cpu_seconds = 0.0;
  double cpu_seconds = 0.0;  ///< of the whole process, from the beginning of set-up until all files were written
  std::uint64_t peak_memory_bytes = 0;
};

/// Which frames tell what all take.
enum class Neighbours {
  kOthers,  ///< frames of a segment but for its first take about as much as each other: two are measured
  kCopied,  ///< the same, where segments may be single frames that others are copied from
};

/// Of the first, the middle and the last segment.
std::vector<int> frames_to_measure(const std::vector<int>& of_job, int segment, Neighbours neighbours);

JobCosts frame_costs(const MeasuredRun& run, const std::vector<int>& of_job, int segment);

/// What a run of these frames takes.
double cpu_seconds_of(const std::vector<int>& frames, int segment, const JobCosts& costs);

}  // namespace lippmann
