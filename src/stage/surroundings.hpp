// Sets the surroundings and the light of a scene.
#pragma once

#include <string>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

struct Surrounding {
  float strength = 1.0f;
  float rotation_deg = 0.0f;
};

/// The light is multiplied by `share` and by how.strength.
void surround_with(Scene& scene, EnvironmentMap map, const Surrounding& how, float share);
void surround_with(Scene& scene, Vec3f color);

/// Implement add_missing_light() (lippmann/stage/lighting.hpp). `how` holds options for panoramas. Both return a sentence for
/// the user.
std::string light_for_whitted(Scene& scene);
std::string light_for_paths(Scene& scene, const Surrounding& how);

}  // namespace lippmann
