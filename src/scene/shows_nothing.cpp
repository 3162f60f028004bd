#include <algorithm>
#include <array>
#include <cstdint>
#include <variant>

#include "lippmann/scene/scene.hpp"

namespace lippmann {
namespace {

bool has_area(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const Vec3d a(mesh.positions[triangle[0]]), b(mesh.positions[triangle[1]]), c(mesh.positions[triangle[2]]);
  return glm::cross(b - a, c - a) != Vec3d(0.0);
}

/// Whether there is anything to be seen. Morph targets and joints may open what is folded up at rest.
bool is_surface(const Shape& shape) {
  const Mesh* mesh = std::get_if<Mesh>(&shape);
  return !mesh || !mesh->targets.empty() || !mesh->skin.joints.empty() ||
         std::any_of(mesh->triangles.begin(), mesh->triangles.end(), [&](const auto& t) { return has_area(*mesh, t); });
}

}  // namespace

bool shows_nothing(const Scene& scene) {
  if (std::any_of(scene.shapes.begin(), scene.shapes.end(), is_surface)) return false;
  const Background& sky = scene.background;
  return !scene.shapes.empty() || (!sky.map && sky.horizon == Vec3f(0.0f) && sky.zenith == Vec3f(0.0f));
}

}  // namespace lippmann
