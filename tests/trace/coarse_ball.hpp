#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "lippmann/scene/scene.hpp"

namespace lippmann::test {

/// A closed ball with smooth normals: two poles, and between them `rings` rings of 2 * rings vertices.
inline Mesh coarse_ball(float radius, std::uint32_t rings) {
  const float step = std::numbers::pi_v<float> / static_cast<float>(rings + 1);
  const std::uint32_t corners = 2 * rings;
  Mesh mesh;
  mesh.normals = {{0, 1, 0}, {0, -1, 0}};
  for (std::uint32_t j = 0; j < rings; ++j)
    for (std::uint32_t i = 0; i < corners; ++i) {
      const float polar = step * static_cast<float>(j + 1),
                  turn = std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(rings);
      mesh.normals.emplace_back(std::sin(polar) * std::cos(turn), std::cos(polar), -std::sin(polar) * std::sin(turn));
    }
  for (const Vec3f n : mesh.normals) mesh.positions.push_back(radius * n);
  const auto corner = [&](std::uint32_t j, std::uint32_t i) { return 2 + j * corners + i % corners; };
  for (std::uint32_t i = 0; i < corners; ++i) {
    mesh.triangles.push_back({0, corner(0, i), corner(0, i + 1)});
    mesh.triangles.push_back({1, corner(rings - 1, i + 1), corner(rings - 1, i)});
    for (std::uint32_t j = 0; j + 1 < rings; ++j) {
      mesh.triangles.push_back({corner(j, i), corner(j + 1, i), corner(j, i + 1)});
      mesh.triangles.push_back({corner(j, i + 1), corner(j + 1, i), corner(j + 1, i + 1)});
    }
  }
  return mesh;
}

}  // namespace lippmann::test
