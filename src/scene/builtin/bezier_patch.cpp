// Based on: Gerald Farin, "Curves and Surfaces for CAGD", 5th ed., 2002, sections 14.1-14.6 (tensor-product patches, their
// derivatives, and normals at degenerate edges).
//
// dP/du is zero along an edge that is a single point. There, the mixed derivative d2P/dudv replaces it.
#include "scene/builtin/bezier_patch.hpp"

#include <cstdint>

namespace lippmann::builtin {
namespace {

using Weights = std::array<float, 4>;

Weights bernstein(float t) {
  const float s = 1.0f - t;
  return {s * s * s, 3.0f * s * s * t, 3.0f * s * t * t, t * t * t};
}

Weights bernstein_slope(float t) {
  const float s = 1.0f - t;
  return {-3.0f * s * s, 3.0f * s * s - 6.0f * s * t, 6.0f * s * t - 3.0f * t * t, 3.0f * t * t};
}

Vec3f blend(const BezierPatch& patch, const Weights& along_u, const Weights& along_v) {
  Vec3f sum(0.0f);
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column) sum += along_v[row] * along_u[column] * patch[row][column];
  return sum;
}

}  // namespace

Vec3f point_on(const BezierPatch& patch, float u, float v) { return blend(patch, bernstein(u), bernstein(v)); }

Vec3f normal_on(const BezierPatch& patch, float u, float v) {
  Vec3f du = blend(patch, bernstein_slope(u), bernstein(v));
  Vec3f dv = blend(patch, bernstein(u), bernstein_slope(v));
  const Vec3f mixed = blend(patch, bernstein_slope(u), bernstein_slope(v));
  // At the edges v = 1 and u = 1, the parameter decreases towards the inside of the patch, so the mixed derivative changes its
  // sign.
  const float size = glm::length(mixed);
  if (glm::length(du) < 1e-5f * size) du = v < 0.5f ? mixed : -mixed;
  if (glm::length(dv) < 1e-5f * size) dv = u < 0.5f ? mixed : -mixed;
  return glm::normalize(glm::cross(du, dv));
}

void tessellate(const BezierPatch& patch, int steps, Mesh& mesh) {
  const std::uint32_t first = static_cast<std::uint32_t>(mesh.positions.size()), row = static_cast<std::uint32_t>(steps) + 1;
  for (int j = 0; j <= steps; ++j)
    for (int i = 0; i <= steps; ++i) {
      const float u = static_cast<float>(i) / static_cast<float>(steps), v = static_cast<float>(j) / static_cast<float>(steps);
      mesh.positions.push_back(point_on(patch, u, v));
      mesh.normals.push_back(normal_on(patch, u, v));
      mesh.uvs.push_back({u, v});
    }
  // If an edge is a single point, rounding errors may separate its vertices.
  const float rounding = 1e-6f * glm::length(patch[3][3] - patch[0][0]);
  const auto apart = [&](std::uint32_t a, std::uint32_t b) {
    return glm::length(mesh.positions[a] - mesh.positions[b]) > rounding;
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (apart(a, b) && apart(b, c) && apart(c, a)) mesh.triangles.push_back({a, b, c});
  };
  for (std::uint32_t j = 0; j + 1 < row; ++j)
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      const std::uint32_t a = first + j * row + i, d = a + row;
      add(a, a + 1, d + 1);
      add(a, d + 1, d);
    }
}

}  // namespace lippmann::builtin
