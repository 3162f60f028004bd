// One light, seen from a point, and how lamps fade.
#pragma once

#include "lippmann/core/math.hpp"
#include "shading/materials.hpp"

namespace lippmann {

struct LightSample {
  Vec3f direction{0.0f};  ///< to the light, unit
  float distance = 0.0f;  ///< shadow rays end before it
  Vec3f radiance{0.0f};   ///< arriving from there; from a point-like light, its irradiance across over its chance
  float density = 0.0f;   ///< chance of the light times density of the direction, per steradian; kInfinity: a point-like light
  bool is_lamp = false;   ///< Phong's highlights answer to it
  bool is_point() const { return density == kInfinity; }
};

/// How much of a lamp goes in a direction (unit, from the point to the lamp): the fading of its cone, or its web's intensity.
float fading(const WhittedLight& light, Vec3f direction);

}  // namespace lippmann
