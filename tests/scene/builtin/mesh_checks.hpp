#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::test {

inline Vec3f area_normal(const Mesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
}

inline int count_degenerate(const Mesh& mesh) {
  int count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) count += glm::length(area_normal(mesh, t)) > 0.0f ? 0 : 1;
  return count;
}

inline int count_normals_not_unit(const Mesh& mesh) {
  int count = 0;
  for (const Vec3f& n : mesh.normals) count += std::abs(glm::length(n) - 1.0f) < 1e-4f ? 0 : 1;
  return count;
}

/// Counts triangles that do not face the sum of their vertex normals. Returns 0 for meshes without normals.
inline int count_facing_wrong(const Mesh& mesh) {
  int count = 0;
  if (mesh.normals.empty()) return count;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    count += glm::dot(area_normal(mesh, t), mesh.normals[a] + mesh.normals[b] + mesh.normals[c]) > 0.0f ? 0 : 1;
  }
  return count;
}

/// Volume of a closed mesh, by the divergence theorem; positive if the surface faces outwards.
inline double signed_volume(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += static_cast<double>(glm::dot(mesh.positions[a], glm::cross(mesh.positions[b], mesh.positions[c])));
  return sum / 6.0;
}

struct BoundaryEdge {
  Vec3f from, to;
};

/// Returns the edges that belong to only one triangle. Vertices closer than about `grid` are treated as one vertex.
inline std::vector<BoundaryEdge> boundary_edges(const Mesh& mesh, float grid = 1e-4f) {
  using Cell = std::tuple<std::int64_t, std::int64_t, std::int64_t>;
  std::map<Cell, std::uint32_t> cells;
  std::vector<std::uint32_t> welded;
  for (const Vec3f& p : mesh.positions) {
    const Vec3f g = p / grid;
    const Cell cell{std::llround(g.x), std::llround(g.y), std::llround(g.z)};
    welded.push_back(cells.emplace(cell, static_cast<std::uint32_t>(cells.size())).first->second);
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, BoundaryEdge>> edges;
  for (const auto& triangle : mesh.triangles)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t from = triangle[corner], to = triangle[(corner + 1) % 3];
      const std::uint32_t a = welded[from], b = welded[to];
      auto& edge = edges[{std::min(a, b), std::max(a, b)}];
      edge.first += a < b ? 1 : -1;  // two triangles use a shared edge in opposite directions
      edge.second = {mesh.positions[from], mesh.positions[to]};
    }
  std::vector<BoundaryEdge> boundary;
  for (const auto& [key, edge] : edges)
    if (edge.first != 0) boundary.push_back(edge.second);
  return boundary;
}

}  // namespace lippmann::test
