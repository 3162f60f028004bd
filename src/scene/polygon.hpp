// Cuts flat polygons, convex or not, into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

using Triangle = std::array<std::uint32_t, 3>;

/// Concave polygons take a time that grows with the square of their corners.
inline constexpr std::size_t kMostConcaveCorners = 10'000;

/// Corner indices of triangles that wind as the polygon does. A polygon that crosses itself or is not flat still gives at most
/// corners - 2 triangles. Empty: no area, or not 3 corners. At most kMostConcaveCorners corners, unless all turn the same way.
std::vector<Triangle> triangulate(std::span<const Vec3f> corners);

/// Whether all corners turn the same way, or not at all.
bool turns_one_way(std::span<const Vec3f> corners);

}  // namespace lippmann
