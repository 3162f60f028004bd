// Computes the depth range that an eye sees through a window over a whole animation.
//
// The result depends on all frames of the timeline, and not on the frames that are rendered. Meshes are exact. Other shapes
// count as their bounding boxes (stage/seen_bounds.hpp). Occluded shapes are included.
#pragma once

#include <optional>

#include "lippmann/core/math.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

/// An eye in front of the plane z = 0 of the display frame, and a centred rectangle in this plane.
struct EyeAtWindow {
  Vec3f eye_mm{0.0f, 0.0f, 300.0f};
  Vec2f window_mm{100.0f};
};

/// The range of visible depths, as z in the display frame (above 0 in front of the display). far_mm is -infinity if an infinite
/// plane is visible up to its horizon.
struct SeenDepth {
  float near_mm = 0.0f, far_mm = 0.0f;
};

/// Returns the range over all frames. Returns nothing if no frame shows anything. The result does not depend on the number of
/// threads.
std::optional<SeenDepth> seen_depth(const Scene& scene, const FittedArray& array, float units_per_mm, const EyeAtWindow& eye,
                                    const ThreadPool& pool);

}  // namespace lippmann
