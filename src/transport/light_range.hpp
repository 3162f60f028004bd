#pragma once

#include <algorithm>
#include <cmath>

#include "lippmann/core/math.hpp"

namespace lippmann {

/// Weaker light counts as 0, so that products do not become denormal. Stronger light is clamped, so that sums and powers stay
/// finite.
inline constexpr float kFaintestLight = 1e-25f, kStrongestLight = 1e30f;

inline float in_light_range(float light) {
  return std::abs(light) >= kFaintestLight ? std::clamp(light, -kStrongestLight, kStrongestLight) : 0.0f;
}

inline Vec3f in_light_range(Vec3f light) { return {in_light_range(light.x), in_light_range(light.y), in_light_range(light.z)}; }

}  // namespace lippmann
