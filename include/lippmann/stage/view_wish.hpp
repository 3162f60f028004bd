// The user's options for the view. The name of a node selects the node and everything below it.
#pragma once

#include <string>

namespace lippmann {

/// Rotation of the view about its target.
struct Orbit {
  float yaw_deg = 0.0f;  ///< positive: the viewer moves to the right
  /// Positive: the viewer moves up, at most to straight above the target.
  float pitch_deg = 0.0f;
  bool operator==(const Orbit&) const = default;
};

struct ViewWish {
  /// Name of a node, X,Y,Z in the world, or a distance from the viewer. May be empty.
  std::string focus{};
  /// Name of a node, or "all" for the whole scene. May be empty.
  std::string fit_to{};
  float zoom = 1.0f;  ///< above 0; the visible size of the plane is divided by zoom
  Orbit orbit{};
};

}  // namespace lippmann
