// Based on: Khronos Group, "KHR_lights_punctual", 2018: point and spot lights have an intensity in candela and fall off with
// the squared distance, directional ones an illuminance in lux; all shine along their node's -z.
#include "scene/gltf/light.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "scene/default_view.hpp"
#include "scene/timeline.hpp"

namespace lippmann::gltf {
namespace {

Light read_light(const tinygltf::Light& from, const std::string& where, const Report& report) {
  Light light;
  light.name = from.name;
  if (!from.color.empty()) light.color = Vec3f(from.color[0], from.color[1], from.color[2]);
  light.color *= static_cast<float>(from.intensity);
  light.range = from.range > 0.0 ? static_cast<float>(from.range) : kInfinity;
  if (from.type == "directional") {
    light.kind = LightKind::kDirectional;
    return light;
  }
  light.inverse_square = true;
  if (from.type == "point") return light;
  light.kind = LightKind::kSpot;
  light.inner_cone = static_cast<float>(from.spot.innerConeAngle);
  light.outer_cone = static_cast<float>(from.spot.outerConeAngle);
  if (light.inner_cone > light.outer_cone) report.fail(where + ".spot", "the inner cone is wider than the outer one");
  return light;
}

/// The rotation that turns -z and y where a node's transform turns them; none where it leaves them no direction.
Quatf orientation(const Affine3f& world_from_node) {
  const Vec3f z = world_from_node.linear[2], x = glm::cross(world_from_node.linear[1], z);
  const float z_length = glm::length(z), x_length = glm::length(x);
  if (!(z_length > 0.0f && x_length > 0.0f && std::isfinite(z_length) && std::isfinite(x_length)))
    return {1.0f, 0.0f, 0.0f, 0.0f};
  const Vec3f unit_z = z / z_length, unit_x = x / x_length;
  return glm::normalize(glm::quat_cast(Mat3f(unit_x, glm::cross(unit_z, unit_x), unit_z)));
}

bool has_lit_surface(const Scene& scene) {
  return std::any_of(scene.instances.begin(), scene.instances.end(), [&](const Instance& instance) {
    const auto& surface = scene.materials[static_cast<std::size_t>(instance.material)].surface;
    return !std::get<MetallicRoughness>(surface).unlit;
  });
}

}  // namespace

void read_lights(Document& document, const NodeMap& nodes, Scene& scene) {
  for (std::size_t i = 0; i < nodes.file_node.size(); ++i) {
    const tinygltf::Node& node = document.model.nodes[static_cast<std::size_t>(nodes.file_node[i])];
    const auto extension = node.extensions.find("KHR_lights_punctual");
    if (extension == node.extensions.end()) continue;
    const std::size_t index = static_cast<std::size_t>(extension->second.Get("light").GetNumberAsInt());
    scene.lights.push_back(read_light(document.model.lights[index], element("lights", index), document.report));
    scene.lights.back().node = static_cast<int>(i);
  }
}

void add_default_light(Document& document, Scene& scene) {
  if (!scene.lights.empty() || !has_lit_surface(scene)) return;
  document.report.warn("has no lights: a key light from above left of the viewer and a dim background are added");

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

}  // namespace lippmann::gltf
