// From where a scene is seen that has no camera of its own: the front, a little from above and from the right, so that depth
// shows.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann {

/// Turns a camera that looks along -z with +y up.
inline Quatf default_view() {
  constexpr float kYaw = radians(25.0f), kPitch = radians(15.0f);  // to the right and up
  return glm::angleAxis(kYaw, Vec3f(0.0f, 1.0f, 0.0f)) * glm::angleAxis(-kPitch, Vec3f(1.0f, 0.0f, 0.0f));
}

}  // namespace lippmann
