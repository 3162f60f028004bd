// The offset from a point on a facet to the smooth surface that the mesh approximates.
//
// After: J. Hanika, "Hacking the Shadow Terminator", Ray Tracing Gems II, 2021, chapter 4. A lamp may be behind a facet but in
// front of the smooth surface. Shadow rays to such lamps start from the smooth surface, so that the terminator is not jagged.
#pragma once

#include <array>

#include "lippmann/core/math.hpp"

namespace lippmann {

struct SmoothTriangle {
  std::array<Vec3f, 3> corners, normals;
  std::array<float, 3> weights;
};

/// Returns the offset from the point to the weighted mean of its projections onto the tangent planes at the corners. A plane
/// below the facet contributes no offset. outer: 1 on the side to which the normals point, -1 on the other side.
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
