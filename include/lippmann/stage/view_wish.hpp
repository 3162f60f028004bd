// What people say of the view instead of leaving it to the fit (stage/fit_array.hpp).
//
// Nodes are called by the name of a node, which stands for everything below it too, or by that of an object that is shown.
#pragma once

#include <string>

namespace lippmann {

/// How far the view is turned about what it looks at.
struct Orbit {
  float yaw_deg = 0.0f;    ///< the viewer moves to the right
  float pitch_deg = 0.0f;  ///< the viewer moves up; not beyond straight above or below
  bool operator==(const Orbit&) const = default;
};

struct ViewWish {
  std::string focus;   ///< a node's name, X,Y,Z in the world, or a distance from the viewer; empty: not given
  std::string fit_to;  ///< a node's name; empty: not given
  float zoom = 1.0f;   ///< > 0; what is seen of the plane is that much smaller
  Orbit orbit;
};

}  // namespace lippmann
