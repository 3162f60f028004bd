#include "scene/nff/cone.hpp"

#include <cmath>

namespace lippmann::nff {

void add_cone(Mesh& mesh, Vec3f base, float base_radius, Vec3f apex, float apex_radius) {
  const Vec3d axis = Vec3d(apex) - Vec3d(base);
  const double length = glm::length(axis);
  const Vec3d w = axis / length, a = glm::abs(w);
  const Vec3d off_axis = a.x <= a.y && a.x <= a.z ? Vec3d(1, 0, 0) : a.y <= a.z ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
  const Vec3d u = glm::normalize(glm::cross(off_axis, w)), v = glm::cross(w, u);
  const double lean = double{base_radius} - double{apex_radius};  // decrease of the radius from base to apex

  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i < kConeSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kConeSides;
    const Vec3d out = std::cos(angle) * u + std::sin(angle) * v;
    const Vec3f normal(glm::normalize(length * out + lean * w));
    mesh.positions.emplace_back(Vec3d(base) + double{base_radius} * out);
    mesh.positions.emplace_back(Vec3d(apex) + double{apex_radius} * out);
    mesh.normals.insert(mesh.normals.end(), 2, normal);
  }
  for (std::uint32_t i = 0; i < kConeSides; ++i) {
    // `here` and `there` are neighbouring vertices of the base. Each is followed in the list by its vertex at the apex.
    const std::uint32_t here = first + 2 * i, there = first + 2 * ((i + 1) % kConeSides);
    if (base_radius > 0.0f) mesh.triangles.push_back({here, there, there + 1});
    if (apex_radius > 0.0f) mesh.triangles.push_back({here, there + 1, here + 1});
  }
}

}  // namespace lippmann::nff
