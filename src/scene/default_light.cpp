#include "scene/default_light.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "lippmann/scene/timeline.hpp"
#include "scene/default_view.hpp"

namespace lippmann {
namespace {

/// Returns the rotation of a node from its -z and y directions, or the identity if the transform is degenerate.
Quatf orientation(const Affine3f& world_from_node) {
  const Vec3f z = world_from_node.linear[2], x = glm::cross(world_from_node.linear[1], z);
  const float z_length = glm::length(z), x_length = glm::length(x);
  if (!(z_length > 0.0f && x_length > 0.0f && std::isfinite(z_length) && std::isfinite(x_length)))
    return {1.0f, 0.0f, 0.0f, 0.0f};
  const Vec3f unit_z = z / z_length, unit_x = x / x_length;
  return glm::normalize(glm::quat_cast(Mat3f(unit_x, glm::cross(unit_z, unit_x), unit_z)));
}

const Material& material_of(const Scene& scene, const Instance& instance) {
  return scene.materials[static_cast<std::size_t>(instance.material)];
}

const MetallicRoughness* physical_surface(const Scene& scene, const Instance& instance) {
  return std::get_if<MetallicRoughness>(&material_of(scene, instance).surface);
}

bool is_lit_by_lamps(const Material& material) {
  if (const auto* phong = std::get_if<PhongSurface>(&material.surface)) return phong->diffuse > 0.0f;
  return !std::get<MetallicRoughness>(material.surface).unlit;
}

bool is_self_lit(const Material& material) {
  const auto* phong = std::get_if<PhongSurface>(&material.surface);
  return phong && (phong->ambient > 0.0f || phong->emission != Vec3f(0.0f));
}

/// Returns whether path tracing treats the material as a light source. Scenes use materials with ambient but no diffuse light
/// for backdrops.
bool is_phong_lamp(const Material& material) {
  const auto* phong = std::get_if<PhongSurface>(&material.surface);
  return phong && (phong->emission != Vec3f(0.0f) || (phong->diffuse == 0.0f && phong->ambient > 0.0f));
}

float brightest(Vec3f color) { return std::max({color.x, color.y, color.z}); }

/// Lights whose channels are all below the smallest normal float do not count, because the renderer rounds them to 0.
bool has_lamps(const Scene& scene) {
  return std::any_of(scene.lights.begin(), scene.lights.end(),
                     [](const Light& light) { return brightest(light.color) >= std::numeric_limits<float>::min(); });
}

double area_of(const Mesh& mesh, const Affine3f& world_from_mesh) {
  double twice = 0.0;
  for (const auto& triangle : mesh.triangles) {
    const Vec3f a = mesh.positions[triangle[0]];
    const Vec3f u = transform_vector(world_from_mesh, mesh.positions[triangle[1]] - a);
    const Vec3f v = transform_vector(world_from_mesh, mesh.positions[triangle[2]] - a);
    twice += static_cast<double>(glm::length(glm::cross(u, v)));
  }
  return 0.5 * twice;
}

bool has_shining_lamps(const Scene& scene) {
  constexpr double kLeastMean = 0.02;
  const ResolvedScene resolved = evaluate(scene, 0.0);
  double area = 0.0, emitted = 0.0;
  for (const Instance& instance : scene.instances) {
    if (is_phong_lamp(material_of(scene, instance))) return true;
    const MetallicRoughness* surface = physical_surface(scene, instance);
    const Mesh* mesh = std::get_if<Mesh>(&scene.shapes[static_cast<std::size_t>(instance.shape)]);
    if (!surface || !mesh || surface->unlit) continue;
    const double here = area_of(*mesh, resolved.of(instance.node));
    area += here;
    if (surface->emissive_map.texture < 0) emitted += here * static_cast<double>(brightest(surface->emissive));
  }
  return emitted > 0.0 && emitted >= kLeastMean * area;
}

}  // namespace

bool lacks_lamps(const Scene& scene) {
  const auto any = [&](bool (*is)(const Material&)) {
    return std::any_of(scene.instances.begin(), scene.instances.end(),
                       [&](const Instance& instance) { return is(material_of(scene, instance)); });
  };
  return !has_lamps(scene) && any(is_lit_by_lamps) && !any(is_self_lit);
}

OwnLight own_light(const Scene& scene) {
  const Background& sky = scene.background;
  if (sky.map || sky.horizon != Vec3f(0.0f) || sky.zenith != Vec3f(0.0f)) return OwnLight::kSurroundings;
  const bool is_lit = std::any_of(scene.instances.begin(), scene.instances.end(),
                                  [&](const Instance& instance) { return is_lit_by_lamps(material_of(scene, instance)); });
  if (!is_lit) return OwnLight::kNotNeeded;
  return !has_lamps(scene) && !has_shining_lamps(scene) ? OwnLight::kNone : OwnLight::kLamps;
}

Quatf viewer_orientation(const Scene& scene) {
  return scene.cameras.empty() ? default_view() : orientation(evaluate(scene, 0.0).of(scene.cameras.front().node));
}

void add_default_light(Scene& scene) {
  // A white diffuse surface that faces the key light gets radiance 0.8 from this light, plus 0.2 from the background's mean.
  // The background is a gradient so that surfaces in shadow stand out from it.
  constexpr float kKey = 0.8f * kPi, kHorizon = 0.08f, kZenith = 0.32f;
  constexpr float kUp = radians(30.0f), kLeft = radians(15.0f);
  const Quatf viewer = viewer_orientation(scene);
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
  Background& sky = scene.background;
  if (sky.map || sky.horizon != Vec3f(0.0f) || sky.zenith != Vec3f(0.0f)) return;
  sky.horizon = Vec3f(kHorizon), sky.zenith = Vec3f(kZenith);
}

}  // namespace lippmann
