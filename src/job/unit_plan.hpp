// Divides a job into units of work, and estimates the cost of each from a few rendered frames.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "job/frame_costs.hpp"
#include "job/resolved_job.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

struct PlannedUnit {
  std::vector<int> frames;
  std::map<int, std::vector<int>> strips = {};  ///< strips to render, by frame; empty: whole frames
  std::optional<double> cpu_seconds = {};       ///< estimated CPU time; nullopt: not measured
};

struct UnitPlan {
  int segment = 1;  ///< units begin at multiples of this number of frames (frames_per_segment)
  std::vector<PlannedUnit> units;
  std::optional<JobCosts> costs = {};
  /// Estimated memory for joining a frame from strips; nullopt: unknown, or no frame is joined.
  std::optional<double> join_bytes = {};
};

/// Plans `count` units, or one per segment if there are fewer segments. With `measure`, renders frames into a temporary folder
/// (core/scratch_folder.hpp). Throws Error for jobs that cannot be rendered.
UnitPlan plan_units(const ResolvedJob& job, int count, bool measure, const Context& context);

}  // namespace lippmann
