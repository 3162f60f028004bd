// How a job falls into units of work, and what each of them is likely to take: a few frames are rendered to find out.
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
  std::map<int, std::vector<int>> strips = {};  ///< by frame; empty: these are rendered whole
  std::optional<double> cpu_seconds = {};       ///< about; none: nothing was measured
};

struct UnitPlan {
  int segment = 1;  ///< frames_per_segment
  std::vector<PlannedUnit> units;
  std::optional<JobCosts> costs = {};
  std::optional<double> join_bytes =
      {};  ///< the memory that joining a frame from strips takes, about; none: not known, or none is
};

/// `count` units or as many as there are segments. With `measure`, frames are rendered into a folder that is thrown away
/// (core/scratch_folder.hpp). Throws Error for jobs that cannot be rendered.
UnitPlan plan_units(const ResolvedJob& job, int count, bool measure, const Context& context);

}  // namespace lippmann
