// From where to where an eye sees something through a window, over a whole animation.
//
// It is a matter of the scene alone: of all frames of its timeline, whichever are rendered. Meshes are exact, other shapes
// count as the boxes around them (stage/seen_bounds.hpp), and so does what stands behind something else.
#pragma once

#include <optional>

#include "lippmann/core/math.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

/// An eye before the plane z = 0 of the display frame, and the rectangle around the middle of that plane that it looks through.
struct EyeAtWindow {
  Vec3f eye_mm{0.0f, 0.0f, 300.0f};
  Vec2f window_mm{100.0f};
};

/// z of the display frame, above 0 in front of the display; -inf where a plane is seen up to its horizon.
struct SeenDepth {
  float near_mm = 0.0f, far_mm = 0.0f;
};

/// None where nothing is seen in any frame. The same for any number of threads.
std::optional<SeenDepth> seen_depth(const Scene& scene, const FittedArray& array, float units_per_mm, const EyeAtWindow& eye,
                                    const ThreadPool& pool);

}  // namespace lippmann
