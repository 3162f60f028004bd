// Based on: T. Möller and B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997, section 2. This file has its
// own loop over triangles, because the command `info` never builds a ray-tracing scene.
#include "stage/enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace lippmann {
namespace {

constexpr int kDirections = 64;

struct EnclosureRay {
  Vec3f origin, direction;
};

/// Returns one of kDirections directions that cover the sphere evenly (a Fibonacci spiral). None lies along an edge of a box.
Vec3f spread_direction(int i) {
  constexpr float kTurn = 2.0f * kPi * (2.0f - std::numbers::phi_v<float>);
  const float z = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / kDirections;
  const float radius = std::sqrt(1.0f - z * z), angle = kTurn * static_cast<float>(i) + 0.3f;
  return {radius * std::cos(angle), z, radius * std::sin(angle)};
}

/// Returns the distance in lengths of ray.direction, or kInfinity. An edge belongs to both adjacent triangles, so that there
/// are no gaps.
float distance_to(const EnclosureRay& ray, Vec3f a, Vec3f b, Vec3f c) {
  constexpr float kEdge = 1e-5f;
  const Vec3f u = b - a, v = c - a, p = glm::cross(ray.direction, v);
  const float determinant = glm::dot(u, p);
  if (determinant == 0.0f) return kInfinity;
  const Vec3f from_a = ray.origin - a, q = glm::cross(from_a, u);
  const float x = glm::dot(from_a, p) / determinant, y = glm::dot(ray.direction, q) / determinant;
  if (!(x >= -kEdge && y >= -kEdge && x + y <= 1.0f + kEdge)) return kInfinity;
  const float distance = glm::dot(v, q) / determinant;
  return distance > 0.0f ? distance : kInfinity;
}

bool meets(const EnclosureRay& ray, const Bounds3f& box) {
  const Vec3f to_lower = (box.lower - ray.origin) / ray.direction, to_upper = (box.upper - ray.origin) / ray.direction;
  const Vec3f near = glm::min(to_lower, to_upper), far = glm::max(to_lower, to_upper);
  return std::max({near.x, near.y, near.z, 0.0f}) <= std::min({far.x, far.y, far.z}) * (1.0f + 1e-5f);
}

enum class LightThrough { kPasses, kShines, kStops };

LightThrough light_through(const Material& material) {
  if (const auto* phong = std::get_if<PhongSurface>(&material.surface)) {
    if (phong->opacity < 1.0f) return LightThrough::kPasses;
    return phong->emission != Vec3f(0.0f) ? LightThrough::kShines : LightThrough::kStops;
  }
  const auto& surface = std::get<MetallicRoughness>(material.surface);
  if (surface.transmission > 0.0f || surface.blend || surface.alpha_cutoff > 0.0f) return LightThrough::kPasses;
  return surface.unlit || surface.emissive != Vec3f(0.0f) ? LightThrough::kShines : LightThrough::kStops;
}

struct Wall {
  const Mesh* mesh;
  Affine3f mesh_from_world;
  Bounds3f bounds;
  bool shines;
};

std::vector<Wall> walls_of(const Scene& scene, const ResolvedScene& resolved) {
  std::vector<Wall> walls;
  for (const Instance& instance : scene.instances) {
    const auto* mesh = std::get_if<Mesh>(&scene.shapes[static_cast<std::size_t>(instance.shape)]);
    const LightThrough light = light_through(scene.materials[static_cast<std::size_t>(instance.material)]);
    const Affine3f& world_from_mesh = resolved.of(instance.node);
    if (!mesh || light == LightThrough::kPasses || glm::determinant(world_from_mesh.linear) == 0.0f) continue;
    Bounds3f bounds;
    for (const Vec3f p : mesh->positions) bounds.add(transform_point(world_from_mesh, p));
    walls.push_back({mesh, inverse(world_from_mesh), bounds, light == LightThrough::kShines});
  }
  return walls;
}

bool sees_light(const std::vector<Wall>& walls, const EnclosureRay& ray) {
  float nearest = kInfinity;
  bool shines = true;  // a ray that hits nothing reaches the light outside
  for (const Wall& wall : walls) {
    if (!meets(ray, wall.bounds)) continue;
    const EnclosureRay in_mesh{transform_point(wall.mesh_from_world, ray.origin),
                               transform_vector(wall.mesh_from_world, ray.direction)};
    for (const auto& [a, b, c] : wall.mesh->triangles) {
      const auto& at = wall.mesh->positions;
      const float distance = distance_to(in_mesh, at[a], at[b], at[c]);
      if (distance < nearest) nearest = distance, shines = wall.shines;
    }
  }
  return shines;
}

}  // namespace

bool is_enclosed(const Scene& scene, const ResolvedScene& resolved, Vec3f point) {
  const std::vector<Wall> walls = walls_of(scene, resolved);
  for (int i = 0; i < kDirections; ++i)
    if (sees_light(walls, {point, spread_direction(i)})) return false;
  return true;
}

}  // namespace lippmann
