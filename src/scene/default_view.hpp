// The default view of scenes without a camera. It is from the front, slightly from above and from the right, so that it shows
// depth.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann {

/// Returns the rotation for a camera that looks along -z with +y up.
inline Quatf default_view() {
  constexpr float kYaw = radians(25.0f), kPitch = radians(15.0f);  // to the right and up
  return glm::angleAxis(kYaw, Vec3f(0.0f, 1.0f, 0.0f)) * glm::angleAxis(-kPitch, Vec3f(1.0f, 0.0f, 0.0f));
}

}  // namespace lippmann
