#pragma once

#include "lippmann/core/math.hpp"
#include "shading/materials.hpp"

namespace lippmann {

struct LightSample {
  Vec3f direction{0.0f};
  float distance = 0.0f;
  /// Radiance that arrives from `direction`. For point-like lights: the irradiance of a surface that faces the light, divided
  /// by the probability of choosing the light.
  Vec3f radiance{0.0f};
  /// Probability of choosing the light, times the probability density of `direction` per steradian. kInfinity for point-like
  /// lights.
  float density = 0.0f;
  bool is_lamp = false;  ///< whether Phong surfaces show highlights of the light
  bool is_point() const { return density == kInfinity; }
};

/// Returns the factor of a lamp's light by direction, from its cone or photometric web. `direction` is a unit vector from the
/// lit point to the lamp.
float fading(const WhittedLight& light, Vec3f direction);

}  // namespace lippmann
