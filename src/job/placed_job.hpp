// The optics of a job, placed in its scene. All code that renders, describes or plans a job uses this placement.
#pragma once

#include <memory>

#include "job/resolved_job.hpp"
#include "job/screen.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/stage/fit_array.hpp"
#include "lippmann/stage/placement.hpp"

namespace lippmann {

struct PlacedJob {
  std::unique_ptr<const Display> display;  ///< null if the job has no display
  FittedArray array;
  PlacedOptics placed;
};

/// The arguments must outlive the result. Throws a usage Error if parameters contradict each other.
Screen screen_of(const ResolvedJob& job, const Scene& scene, const Display* display);

/// Loads the job's display, fits the array to the scene, and makes the optics. Rays start at the viewer, or behind
/// walls that hide the scene from the viewer but not from the file's camera. `scene` must pass validate(). Throws Error
/// if the display cannot be read, and a usage Error if parameters contradict each other or no rays exist for them.
PlacedJob place(const ResolvedJob& job, const Scene& scene);

}  // namespace lippmann
