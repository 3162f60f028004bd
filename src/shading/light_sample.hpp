// A light sampled from a point, and the fading of lamps.
#pragma once

#include "lippmann/core/math.hpp"
#include "shading/materials.hpp"

namespace lippmann {

struct LightSample {
  Vec3f direction{0.0f};  ///< unit, to the light
  float distance = 0.0f;  ///< distance at which the shadow ray ends
  Vec3f radiance{
      0.0f};  ///< radiance from the direction; for point-like lights, the irradiance across it divided by the probability
  /// Probability of the light times density of the direction, per steradian; kInfinity for point-like lights.
  float density = 0.0f;
  bool is_lamp = false;  ///< makes highlights on Phong surfaces
  bool is_point() const { return density == kInfinity; }
};

/// Returns the factor of a lamp for a direction (unit, from the point to the lamp): its cone's fading, or its web's intensity.
float fading(const WhittedLight& light, Vec3f direction);

}  // namespace lippmann
