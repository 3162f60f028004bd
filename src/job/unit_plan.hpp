// Divides a job into units, which different runs render, and estimates the cost of each from a few rendered frames.
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
  /// Strips to render, by frame; empty: whole frames.
  std::map<int, std::vector<int>> strips = {};
  std::optional<double> cpu_seconds = {};  ///< nullopt: not measured
};

struct UnitPlan {
  /// Number of successive frames in a segment (frames_per_segment()). The frames of a segment are always in the same unit.
  int segment = 1;
  std::vector<PlannedUnit> units;
  std::optional<JobCosts> costs = {};
  /// Estimated memory for joining a frame from strips; nullopt: unknown, or no frame is joined.
  std::optional<double> join_bytes = {};
};

/// Plans `count` units, or one per segment (UnitPlan::segment) if the job has fewer segments. With `measure`, renders some
/// frames into a temporary folder (core/scratch_folder.hpp) and estimates costs. Throws Error for jobs that cannot be rendered.
UnitPlan plan_units(const ResolvedJob& job, int count, bool measure, const Context& context);

}  // namespace lippmann
