#include <cmath>
#include <cstdint>
#include <vector>

#include "scene/builtin/meshes.hpp"

namespace lippmann::builtin {
namespace {

using Index = std::uint32_t;

struct Corner {
  Index triangle, corner;
};

Vec3f area_normal(const Mesh& mesh, const std::array<Index, 3>& t) {
  return glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
}

std::vector<std::vector<Corner>> corners_of_vertices(const Mesh& mesh) {
  std::vector<std::vector<Corner>> corners(mesh.positions.size());
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    for (Index c = 0; c < 3; ++c) corners[mesh.triangles[t][c]].push_back({t, c});
  return corners;
}

}  // namespace

Mesh with_creases(const Mesh& welded, float crease_angle) {
  const float cosine = std::cos(crease_angle);
  std::vector<Vec3f> faces;
  for (const auto& t : welded.triangles) faces.push_back(area_normal(welded, t));

  Mesh mesh;
  mesh.triangles = welded.triangles;
  const std::vector<std::vector<Corner>> corners_of = corners_of_vertices(welded);
  for (Index vertex = 0; vertex < corners_of.size(); ++vertex) {
    const Index first = static_cast<Index>(mesh.positions.size());
    for (const Corner& corner : corners_of[vertex]) {
      Vec3f normal(0.0f);
      for (const Corner& other : corners_of[vertex]) {
        const Vec3f &a = faces[corner.triangle], &b = faces[other.triangle];
        if (glm::dot(a, b) >= cosine * glm::length(a) * glm::length(b)) normal += b;
      }
      normal = glm::normalize(normal);
      Index index = first;
      while (index < mesh.positions.size() && glm::dot(mesh.normals[index], normal) < 0.99999f) ++index;
      if (index == mesh.positions.size()) {
        mesh.positions.push_back(welded.positions[vertex]);
        mesh.normals.push_back(normal);
      }
      mesh.triangles[corner.triangle][corner.corner] = index;
    }
  }
  return mesh;
}

}  // namespace lippmann::builtin
