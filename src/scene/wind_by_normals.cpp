#include "scene/wind_by_normals.hpp"

#include <utility>

namespace lippmann {
namespace {

using MeshTriangle = std::array<std::uint32_t, 3>;

/// Uses double precision because the products of coordinates up to 1e18 overflow floats.
bool faces_away(const Mesh& mesh, const MeshTriangle& triangle) {
  const Vec3d a(mesh.positions[triangle[0]]), b(mesh.positions[triangle[1]]), c(mesh.positions[triangle[2]]);
  Vec3d outwards(0.0);
  for (const std::uint32_t vertex : triangle) outwards += Vec3d(mesh.normals[vertex]);
  return glm::dot(glm::cross(b - a, c - a), outwards) < 0.0;
}

}  // namespace

void wind_by_normals(Mesh& mesh) {
  if (mesh.normals.empty()) return;
  for (MeshTriangle& triangle : mesh.triangles)
    if (faces_away(mesh, triangle)) std::swap(triangle[1], triangle[2]);
}

}  // namespace lippmann
