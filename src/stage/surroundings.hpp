// Sets the surroundings and light of a scene in its background.
#pragma once

#include <string>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Options for panoramas.
struct Surrounding {
  float strength = 1.0f;  ///< factor for the light
  float rotation_deg = 0.0f;
};

/// Sets a panorama as the surroundings. The light is multiplied by `share` and by how.strength.
void surround_with(Scene& scene, EnvironmentMap map, const Surrounding& how, float share);
/// Surrounds the scene with the same linear light in all directions.
void surround_with(Scene& scene, Vec3f color);

/// Implement add_missing_light() (lippmann/stage/lighting.hpp) for Whitted shading and for path tracing. `how` holds options
/// for panoramas. Both return a sentence on the light.
std::string light_for_whitted(Scene& scene);
std::string light_for_paths(Scene& scene, const Surrounding& how);

}  // namespace lippmann
