#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

struct PlanarRegion {
  std::vector<Vec2f> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  std::uint32_t add(Vec2f p) {
    points.push_back(p);
    return static_cast<std::uint32_t>(points.size()) - 1;
  }
};

/// Points on a closed curve around the origin, in counter-clockwise order.
struct AngularRing {
  std::vector<std::uint32_t> points;
  std::vector<float> angles;
  void add(std::uint32_t point, float angle) { points.push_back(point), angles.push_back(angle); }
};

void fill_between(PlanarRegion& region, const AngularRing& inner, const AngularRing& outer);

/// Returns a closed solid that is symmetric about z = 0, with bevelled edges and creased normals. `bevel` must be less than
/// half the thickness, and less than half the width of the region at its narrowest place.
Mesh extrude(const PlanarRegion& region, float thickness, float bevel);

}  // namespace lippmann::builtin
