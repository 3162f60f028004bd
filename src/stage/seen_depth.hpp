// Computes the depth range that an eye sees through a window over a whole animation. Shapes other than meshes count as their
// bounding boxes. Occluded shapes are included.
#pragma once

#include <optional>

#include "lippmann/core/math.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

struct EyeAtWindow {
  Vec3f eye_mm{0.0f, 0.0f, 300.0f};
  Vec2f window_mm{100.0f};
};

/// Range of z in the display frame, above 0 in front of the display. far_mm is -infinity for an infinite plane that is visible
/// up to its horizon.
struct SeenDepth {
  float near_mm = 0.0f, far_mm = 0.0f;
};

std::optional<SeenDepth> seen_depth(const Scene& scene, const FittedArray& array, float units_per_mm, const EyeAtWindow& eye,
                                    const ThreadPool& pool);

}  // namespace lippmann
