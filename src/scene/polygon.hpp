#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

using Triangle = std::array<std::uint32_t, 3>;

/// Maximum number of corners of a concave polygon, because triangulation takes quadratic time.
inline constexpr std::size_t kMostConcaveCorners = 10'000;

/// Returns triangles of corner indices with the winding of the polygon, at most corners - 2. Returns none for polygons without
/// area or with fewer than 3 corners. Callers must refuse concave polygons with more than kMostConcaveCorners corners.
std::vector<Triangle> triangulate(std::span<const Vec3f> corners);

bool turns_one_way(std::span<const Vec3f> corners);

}  // namespace lippmann
