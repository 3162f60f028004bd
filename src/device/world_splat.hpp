// A splat in world space for ray intersection.
//
// Based on: N. Moenne-Loccoz and others, "3D Gaussian Ray Tracing: Fast Tracing of Particle Scenes", SIGGRAPH Asia 2024,
// section 4.2 (a Gaussian is evaluated at its maximum along the ray).
#pragma once

#include <cstdint>

#include "device/fast_math.hpp"
#include "device/primitives.hpp"

namespace lippmann {

struct WorldSplat {
  float m[9];  ///< columns of the matrix from world offsets to offsets in standard deviations
  float x, y, z;
  float opacity;
  float reach;  ///< squared distance from the centre up to which the splat is visible, in squared standard deviations
  std::uint32_t source, set;
};
static_assert(sizeof(WorldSplat) == 64, "one line of the cache");

/// The point of a ray where the distance from the splat's centre, in standard deviations, is smallest: `t` is its ray
/// parameter, and `squared` its squared distance. The ray's direction must have unit length.
///
/// approach() computes this point as an offset from the ray's point that is nearest to the centre in world space, which avoids
/// cancellation for distant eyes and flat splats.
struct SplatApproach {
  float t, squared;
};

LIPPMANN_INLINE SplatApproach approach(const WorldSplat& s, const LaneRay& r) {
  const float cx = s.x - r.ox, cy = s.y - r.oy, cz = s.z - r.oz;
  const float near = cx * r.dx + cy * r.dy + cz * r.dz;
  const float px = near * r.dx - cx, py = near * r.dy - cy, pz = near * r.dz - cz;
  const float qx = s.m[0] * px + s.m[3] * py + s.m[6] * pz;
  const float qy = s.m[1] * px + s.m[4] * py + s.m[7] * pz;
  const float qz = s.m[2] * px + s.m[5] * py + s.m[8] * pz;
  const float ex = s.m[0] * r.dx + s.m[3] * r.dy + s.m[6] * r.dz;
  const float ey = s.m[1] * r.dx + s.m[4] * r.dy + s.m[7] * r.dz;
  const float ez = s.m[2] * r.dx + s.m[5] * r.dy + s.m[8] * r.dz;
  const float along = -(qx * ex + qy * ey + qz * ez) / (ex * ex + ey * ey + ez * ez);
  const float fx = qx + along * ex, fy = qy + along * ey, fz = qz + along * ez;
  return {near + along, fx * fx + fy * fy + fz * fz};
}

/// Returns the splat's opacity at a point. `squared` is the point's squared distance from the centre, in squared standard
/// deviations.
LIPPMANN_INLINE float alpha_at(const WorldSplat& s, float squared) {
  constexpr float kHalfLog2E = 0.72134752f;
  return s.opacity * fast_exp2(-kHalfLog2E * squared);
}

}  // namespace lippmann
