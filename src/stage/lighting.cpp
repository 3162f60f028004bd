#include "lippmann/stage/lighting.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "lippmann/scene/load.hpp"
#include "lippmann/stage/fit_array.hpp"
#include "scene/default_light.hpp"
#include "scene/studio_light.hpp"
#include "stage/enclosure.hpp"
#include "stage/surroundings.hpp"

namespace lippmann {
namespace {

/// The lamp has no falloff, so it lights rooms of any size. A white diffuse surface that faces the lamp has half the radiance
/// of display white.
void add_lamp_at_viewer(Scene& scene, const FittedArray& array) {
  constexpr float kAtViewer = 0.5f * kPi;
  Node node;
  node.name = "lamp at the viewer";
  node.parent = array.node;
  node.local.translation = transform_point(array.node_from_plane, {0.0f, 0.0f, array.viewing_distance});
  Light light;
  light.name = node.name;
  light.color = Vec3f(kAtViewer);
  light.node = static_cast<int>(scene.nodes.size());
  scene.nodes.push_back(std::move(node));
  scene.lights.push_back(std::move(light));
}

/// Adds a lamp if the viewer is in a closed room, which would hide the studio light. Returns whether the room is closed.
bool light_closed_room(Scene& scene) {
  const FittedArray array = fit_array(scene);
  if (!std::isfinite(array.viewing_distance)) return false;
  const ResolvedScene resolved = evaluate(scene, scene.timeline.time(0));
  const Vec3f viewer = transform_point(world_from_display(array, 1.0f, resolved), {0.0f, 0.0f, array.viewing_distance});
  if (!is_enclosed(scene, resolved, viewer)) return false;
  add_lamp_at_viewer(scene, array);
  return true;
}

}  // namespace

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
  if (own == OwnLight::kSurroundings) {
    if (scene.background.map) surround_with(scene, EnvironmentMap(*scene.background.map), how, 1.0f);
    return "The scene has its own light.";
  }
  const bool has_lamps = own == OwnLight::kLamps;
  surround_with(scene, studio_environment(viewer_orientation(scene)), how, has_lamps ? kDimStudio : 1.0f);
  if (!has_lamps && light_closed_room(scene))
    return "A lamp at the viewer lights the scene, because the file has no lamps and its walls keep out the built-in studio's "
           "light.";
  if (!has_lamps) return "The built-in studio lights the scene, because the file has no lamps and no surroundings.";
  return fmt::format(
      "The file's {} light the scene; the built-in studio surrounds it at {:.0f} % of its brightness, because the file has "
      "no surroundings.",
      scene.lights.empty() ? "emissive surfaces" : "lamps", 100.0 * static_cast<double>(kDimStudio));
}

void surround_with_studio(Scene& scene, float strength, float rotation_deg) {
  surround_with(scene, studio_environment(viewer_orientation(scene)), {strength, rotation_deg}, 1.0f);
}

std::string add_missing_light(Scene& scene, Integrator integrator) {
  validate(scene, "scene");
  return integrator.facts().is_lit_by_surroundings ? light_for_paths(scene, Surrounding{}) : light_for_whitted(scene);
}

}  // namespace lippmann
