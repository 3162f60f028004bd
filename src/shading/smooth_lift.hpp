// From a point of a facet to the smooth surface that the mesh stands for, whose normals it has.
//
// After: J. Hanika, "Hacking the Shadow Terminator", Ray Tracing Gems II, 2021, chapter 4. Where a lamp is about to set, its
// light comes from behind some facets, though the smooth normal still sees it: these would be dark one by one, as a staircase.
// Rays to such lamps start from the smooth surface, which lies above the facets where the mesh bulges.
#pragma once

#include <array>

#include "lippmann/core/math.hpp"

namespace lippmann {

/// Three corners of a triangle with their normals, of any length but 0, and where in it (weights of the corners).
struct SmoothTriangle {
  std::array<Vec3f, 3> corners, normals;
  std::array<float, 3> weights;
};

/// Up to the planes that touch the smooth surface at the corners, by the point's weights; the null vector where the surface
/// lies below the facet there. outer: 1, or -1 as seen from the side that the normals point away from.
inline Vec3f smooth_lift(const SmoothTriangle& t, float outer) {
  Vec3f point(0.0f), lift(0.0f);
  for (std::size_t k = 0; k < 3; ++k) point += t.weights[k] * t.corners[k];
  for (std::size_t k = 0; k < 3; ++k) {
    const float square = glm::dot(t.normals[k], t.normals[k]);
    const float below = -outer * glm::dot(point - t.corners[k], t.normals[k]);
    if (square > 0.0f && below > 0.0f) lift += outer * t.weights[k] * below / square * t.normals[k];
  }
  return lift;
}

}  // namespace lippmann
