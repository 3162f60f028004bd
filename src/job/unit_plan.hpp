// How a job falls into units of work, and what each of them is likely to take: a few frames are rendered to find out.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "job/params.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

/// What frames take, measured at the beginning, in the middle and at the end of the animation.
struct FrameCosts {
  double setup_seconds = 0.0;           ///< wall time of loading and building, which every unit pays
  double first_cpu_seconds = 0.0;       ///< for the first frame of a segment, all threads together
  double other_cpu_seconds = 0.0;       ///< for any other frame
  double source_cpu_seconds = 0.0;      ///< for all frames that a unit renders beside its own
  std::uint64_t peak_memory_bytes = 0;  ///< the most that the measuring process has held
  std::vector<int> frames;              ///< that were measured
};

struct PlannedUnit {
  std::vector<int> frames;
  std::optional<double> cpu_seconds = {};  ///< about; none: nothing was measured
};

struct UnitPlan {
  int segment = 1;  ///< frames_per_segment
  std::vector<PlannedUnit> units;
  std::optional<FrameCosts> costs = {};
};

/// `count` units or as many as there are segments. With `measure`, frames are rendered and thrown away. Throws Error for jobs
/// that cannot be rendered.
UnitPlan plan_units(const RenderParams& params, int count, bool measure, const Context& context);

}  // namespace lippmann
