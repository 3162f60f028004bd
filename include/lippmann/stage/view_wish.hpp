// The user's options for the view (stage/fit_array.hpp).
//
// A node is selected by its name, together with everything below it in the hierarchy. The name of a visible object selects that
// object.
#pragma once

#include <string>

namespace lippmann {

/// Rotation of the view about its target.
struct Orbit {
  float yaw_deg = 0.0f;    ///< positive: the viewer moves to the right
  float pitch_deg = 0.0f;  ///< positive: the viewer moves up; limited to straight above or below
  bool operator==(const Orbit&) const = default;
};

struct ViewWish {
  std::string focus{};  ///< a node's name, X,Y,Z in the world, or a distance from the viewer; may be empty
  /// A node's name, or "all" for the whole scene (unless a node has this name); may be empty.
  std::string fit_to{};
  float zoom = 1.0f;  ///< > 0; the visible size of the plane is divided by it
  Orbit orbit{};
};

}  // namespace lippmann
