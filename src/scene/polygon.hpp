// Triangulates flat polygons, convex or concave.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

using Triangle = std::array<std::uint32_t, 3>;

/// The largest number of corners of a concave polygon. The triangulation of concave polygons takes quadratic time.
inline constexpr std::size_t kMostConcaveCorners = 10'000;

/// Returns triangles of corner indices with the winding of the polygon. There are at most corners - 2 triangles, even for
/// self-intersecting or non-planar polygons. Returns none for polygons without area or with fewer than 3 corners. Callers must
/// refuse concave polygons with more than kMostConcaveCorners corners.
std::vector<Triangle> triangulate(std::span<const Vec3f> corners);

/// Returns whether all corners turn in the same direction, as in a convex polygon.
bool turns_one_way(std::span<const Vec3f> corners);

}  // namespace lippmann
