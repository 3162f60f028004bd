// The default view of scenes without a camera: from the front, slightly from above and from the right.
#pragma once

#include "lippmann/core/math.hpp"

namespace lippmann {

inline Quatf default_view() {
  constexpr float kYaw = radians(25.0f), kPitch = radians(15.0f);
  return glm::angleAxis(kYaw, Vec3f(0.0f, 1.0f, 0.0f)) * glm::angleAxis(-kPitch, Vec3f(1.0f, 0.0f, 0.0f));
}

}  // namespace lippmann
