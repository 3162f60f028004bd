// The eye of a viewer, at a point or infinitely far away.
//
// The optics need only the slope of the line from the eye through a point (x, y) of the plane z = 0, in mm sideways per mm
// towards the viewer:
//   slope = slope_at_centre - (x, y) vergence
// An eye at (X, Y, Z) has slope_at_centre = (X, Y) / Z and vergence 1 / Z. An infinitely distant eye has vergence 0.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann {

struct Viewer {
  Vec2d slope_at_centre{0.0};
  double vergence = 0.0;  ///< 1 / distance, per mm

  Vec2d slope_at(Vec2d point_mm) const { return slope_at_centre - point_mm * vergence; }
};

/// Returns the viewer at a point; eye_mm.z > 0.
inline Viewer viewer_at(Vec3d eye_mm) { return {Vec2d(eye_mm) / eye_mm.z, 1.0 / eye_mm.z}; }

}  // namespace lippmann
