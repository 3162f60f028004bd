// Texture coordinates and blur of projected textures: Tachyon's planar, cylindrical and spherical image maps.
//
// Let q = point - center and w = v_axis x u_axis. angle(q) is the angle of q around v_axis in turns, from u_axis towards w.
// path is the length of the whole path from the eye to the point, including mirrors.
//   plane     U = q.u_axis       V = q.v_axis                                       L = path
//   cylinder  U = angle(q)       V = q.v_axis                                       L = path / (8 |q|)
//   sphere    U = angle(q)       V = angle between q and -v_axis, in half turns     L = path / (8 |q|)
//   u = frac(U scale.x + rotate.x),  v = frac(V scale.y + rotate.y),  where frac(x) = x - floor(x)
//   blur = min(1, 0.05 L max(|scale.x|, |scale.y|))
// Blur 0 stands for the full texture, and 1 for its mean.
#pragma once

#include "device/lanes.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

struct ProjectedLanes {
  Lanes u, v;
  Lanes blur;
};

/// Computes coordinates and blur for the wanted lanes. Other lanes get arbitrary values in [0, 1].
void project(const ImageProjection& projection, const Lanes3& point, const Lanes& path_length, const LaneMask& wanted,
             ProjectedLanes& at);

}  // namespace lippmann
