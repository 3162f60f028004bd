#include "lippmann/stage/lighting.hpp"

#include <fmt/format.h>

#include <utility>

#include "scene/default_light.hpp"
#include "scene/studio_light.hpp"
#include "stage/surroundings.hpp"

namespace lippmann {

void surround_with(Scene& scene, EnvironmentMap map, const Surrounding& how, float share) {
  map.strength *= share * how.strength;
  map.rotation += radians(how.rotation_deg);
  scene.background.map = std::move(map);
}

void surround_with(Scene& scene, Vec3f color) {
  scene.background.map.reset();
  scene.background.horizon = scene.background.zenith = color;
}

std::string light_for_whitted(Scene& scene) {
  if (!lacks_lamps(scene)) return "The scene has its own light.";
  add_default_light(scene);
  return "A key light from above left of the viewer lights the scene, because the file has no lamps.";
}

std::string light_for_paths(Scene& scene, const Surrounding& how) {
  const OwnLight own = own_light(scene);
  if (own == OwnLight::kNotNeeded) return "The scene's surfaces show their colours without light.";
  if (own == OwnLight::kSurroundings) return "The scene has its own light.";
  const bool has_lamps = own == OwnLight::kLamps;
  surround_with(scene, studio_environment(viewer_orientation(scene)), how, has_lamps ? kDimStudio : 1.0f);
  if (!has_lamps) return "The built-in studio lights the scene, because the file has no lamps and no surroundings.";
  return fmt::format(
      "The file's lamps light the scene; the built-in studio surrounds it at {:.0f} % of its brightness, because the file has "
      "no surroundings.",
      100.0 * static_cast<double>(kDimStudio));
}

std::string add_missing_light(Scene& scene, Integrator integrator) {
  return integrator == Integrator::kWhitted ? light_for_whitted(scene) : light_for_paths(scene, Surrounding{});
}

}  // namespace lippmann
