// A splat as rays meet it, in world space: how near a ray comes to it, and how much it covers there.
//
// Based on: N. Moenne-Loccoz and others, "3D Gaussian Ray Tracing: Fast Tracing of Particle Scenes", SIGGRAPH Asia 2024,
// section 4.2: a Gaussian counts with its largest value along the ray.
#pragma once

#include <cstdint>

#include "device/fast_math.hpp"
#include "device/primitives.hpp"

namespace lippmann {

struct WorldSplat {
  float m[9];                 ///< from world to standard deviations, linear part, columns
  float x, y, z;              ///< centre
  float opacity;              ///< 0 to 1
  float reach;                ///< squared distance from the centre, in standard deviations, up to which it is seen
  std::uint32_t source, set;  ///< which of the splats of SplatTable::sets[set] it is
};
static_assert(sizeof(WorldSplat) == 64, "one line of the cache");

/// Where a ray of unit length comes nearest to a splat in standard deviations: `t`, and the squared distance there.
///
/// The splat's space begins at the point of the ray that is nearest to the centre in the world, so that far eyes and flat
/// splats lose no digits.
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

/// What it covers at that squared distance.
LIPPMANN_INLINE float alpha_at(const WorldSplat& s, float squared) {
  constexpr float kHalfLog2E = 0.72134752f;
  return s.opacity * fast_exp2(-kHalfLog2E * squared);
}

}  // namespace lippmann
