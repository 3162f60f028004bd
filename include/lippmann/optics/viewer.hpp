// From where a light panel is looked at: an eye at a point, or one infinitely far away.
//
// All that optics asks of an eye is the slope of its line through a point (x, y) of the plane z = 0: how many mm the line moves
// sideways per mm towards the viewer.
//   slope = slope_at_centre - (x, y) vergence
// An eye at (X, Y, Z) has slope_at_centre = (X, Y) / Z and vergence 1 / Z; an infinitely far one, vergence 0.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann {

struct Viewer {
  Vec2d slope_at_centre{0.0};
  double vergence = 0.0;  ///< 1 / distance, per mm

  Vec2d slope_at(Vec2d point_mm) const { return slope_at_centre - point_mm * vergence; }
};

/// eye_mm.z > 0.
inline Viewer viewer_at(Vec3d eye_mm) { return {Vec2d(eye_mm) / eye_mm.z, 1.0 / eye_mm.z}; }

}  // namespace lippmann
