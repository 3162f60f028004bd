// Texture coordinates and blur of projected textures: Tachyon's planar, cylindrical and spherical image maps.
//
// With q = point - center, w = v_axis x u_axis and angle(q) = the angle of q around v_axis, from u_axis towards w, in turns:
//   plane     U = q.u_axis       V = q.v_axis                                       L = path
//   cylinder  U = angle(q)       V = q.v_axis                                       L = path / (8 |q|)
//   sphere    U = angle(q)       V = angle between q and -v_axis, in half turns     L = path / (8 |q|)
//   u = fraction of U scale.x + rotate.x,  v = fraction of V scale.y + rotate.y,  each in [0, 1)
//   blur = min(1, 0.05 L max(|scale.x|, |scale.y|)): 0 is the full texture, 1 its mean
// path is the length of the whole path from the eye, including mirrors.
#pragma once

#include "device/lanes.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

struct ProjectedLanes {
  Lanes u, v;  ///< [0, 1]
  Lanes blur;  ///< [0, 1]
};

/// Computes the coordinates of the wanted lanes. Other lanes get arbitrary coordinates within range.
void project(const ImageProjection& projection, const Lanes3& point, const Lanes& path_length, const LaneMask& wanted,
             ProjectedLanes& at);

}  // namespace lippmann
