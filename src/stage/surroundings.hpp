// What surrounds and lights a scene, put into its background.
#pragma once

#include <string>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// How panoramas are taken.
struct Surrounding {
  float strength = 1.0f;  ///< factor
  float rotation_deg = 0.0f;
};

/// `share`: another factor on its light.
void surround_with(Scene& scene, EnvironmentMap map, const Surrounding& how, float share);
/// Linear light, the same in all directions.
void surround_with(Scene& scene, Vec3f color);

/// The parts of add_missing_light() (lippmann/stage/lighting.hpp), with panoramas taken so.
std::string light_for_whitted(Scene& scene);
std::string light_for_paths(Scene& scene, const Surrounding& how);

}  // namespace lippmann
