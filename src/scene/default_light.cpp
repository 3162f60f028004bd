#include "scene/default_light.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "scene/default_view.hpp"
#include "scene/timeline.hpp"

namespace lippmann {
namespace {

/// The rotation that turns -z and y where a node's transform turns them; none where it leaves them no direction.
Quatf orientation(const Affine3f& world_from_node) {
  const Vec3f z = world_from_node.linear[2], x = glm::cross(world_from_node.linear[1], z);
  const float z_length = glm::length(z), x_length = glm::length(x);
  if (!(z_length > 0.0f && x_length > 0.0f && std::isfinite(z_length) && std::isfinite(x_length)))
    return {1.0f, 0.0f, 0.0f, 0.0f};
  const Vec3f unit_z = z / z_length, unit_x = x / x_length;
  return glm::normalize(glm::quat_cast(Mat3f(unit_x, glm::cross(unit_z, unit_x), unit_z)));
}

const MetallicRoughness* physical_surface(const Scene& scene, const Instance& instance) {
  return std::get_if<MetallicRoughness>(&scene.materials[static_cast<std::size_t>(instance.material)].surface);
}

}  // namespace

bool lacks_light(const Scene& scene, bool emission_lights) {
  if (!scene.lights.empty()) return false;
  bool lit = false;
  for (const Instance& instance : scene.instances) {
    const MetallicRoughness* surface = physical_surface(scene, instance);
    if (!surface) continue;
    if (emission_lights && (surface->unlit || surface->emissive != Vec3f(0.0f))) return false;
    lit |= !surface->unlit;
  }
  return lit;
}

void add_default_light(Scene& scene) {
  // A white diffuse surface that faces the key light shows 0.8 of display white and the background's mean, 0.2, on top; one in
  // shadow shows the mean alone. The background is a gradient so that such a surface does not vanish in front of it.
  constexpr float kKey = 0.8f * kPi, kHorizon = 0.08f, kZenith = 0.32f;
  constexpr float kUp = radians(30.0f), kLeft = radians(15.0f);
  const Quatf viewer =
      scene.cameras.empty() ? default_view() : orientation(evaluate(scene, 0.0).of(scene.cameras.front().node));
  Node node;
  node.name = "default light";
  node.local.rotation =
      glm::normalize(viewer * glm::angleAxis(-kLeft, Vec3f(0.0f, 1.0f, 0.0f)) * glm::angleAxis(-kUp, Vec3f(1.0f, 0.0f, 0.0f)));
  Light light;
  light.name = node.name;
  light.kind = LightKind::kDirectional;
  light.color = Vec3f(kKey);
  light.node = static_cast<int>(scene.nodes.size());
  scene.nodes.push_back(std::move(node));
  scene.lights.push_back(std::move(light));
  scene.background.horizon = Vec3f(kHorizon);
  scene.background.zenith = Vec3f(kZenith);
}

}  // namespace lippmann
