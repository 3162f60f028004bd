// A light sampled from a point, and the emission of lamps by direction.
#pragma once

#include "lippmann/core/math.hpp"
#include "shading/materials.hpp"

namespace lippmann {

struct LightSample {
  Vec3f direction{0.0f};  ///< unit length, from the point to the light
  float distance = 0.0f;  ///< length of the shadow ray
  /// Radiance that arrives from `direction`. For point-like lights: the irradiance of a surface that faces the light, divided
  /// by the probability of choosing the light.
  Vec3f radiance{0.0f};
  /// Probability of choosing the light times the density of `direction` per steradian. kInfinity for point-like lights.
  float density = 0.0f;
  bool is_lamp = false;  ///< true: Phong surfaces show highlights of the light
  bool is_point() const { return density == kInfinity; }
};

/// Returns the factor of a lamp's light by direction: the fading in its cone, or the intensity of its photometric web.
/// `direction` has unit length and points from the lit point to the lamp.
float fading(const WhittedLight& light, Vec3f direction);

}  // namespace lippmann
