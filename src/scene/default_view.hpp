// The default view of scenes without a camera: from the front, slightly from above and from the right, so that depth is
// visible.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann {

/// Returns the rotation of a camera, which looks along -z with +y up, to the default view.
inline Quatf default_view() {
  constexpr float kYaw = radians(25.0f), kPitch = radians(15.0f);  // the camera is to the right of the scene and above it
  return glm::angleAxis(kYaw, Vec3f(0.0f, 1.0f, 0.0f)) * glm::angleAxis(-kPitch, Vec3f(1.0f, 0.0f, 0.0f));
}

}  // namespace lippmann
