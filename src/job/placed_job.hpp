// A job's optics, placed in its scene. Everything that renders, describes or plans a job takes them from here.
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
  std::unique_ptr<const Display> display;  ///< null: the job has no display
  FittedArray array;
  PlacedOptics placed;
};

/// Returns the screen of a job. The arguments must outlive the result. Throws a usage Error if parameters contradict each
/// other.
Screen screen_of(const ResolvedJob& job, const Scene& scene, const Display* display);

/// Loads the job's display, fits the array to the scene, and makes the optics. Rays start at the viewer, or
/// behind walls that the file's camera does not see, so that a camera inside a room shows the room. `scene` must pass
/// validate(). Throws Error for a display that cannot be read, and a usage Error for parameters that contradict each other or
/// make no rays.
PlacedJob place(const ResolvedJob& job, const Scene& scene);

}  // namespace lippmann
