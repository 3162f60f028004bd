#pragma once

#include <array>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

/// The control points, stored as points[row][column]. u runs along a row, v from the first row to the last.
using BezierPatch = std::array<std::array<Vec3f, 4>, 4>;

Vec3f point_on(const BezierPatch& patch, float u, float v);

/// Returns the unit normal along dP/du x dP/dv, or its limit at an edge that is a single point.
Vec3f normal_on(const BezierPatch& patch, float u, float v);

/// Adds (steps + 1)^2 vertices and up to 2 steps^2 triangles, counter-clockwise from the side that the normal points to. Skips
/// triangles without area. The texture coordinates are (u, v).
void tessellate(const BezierPatch& patch, int steps, Mesh& mesh);

}  // namespace lippmann::builtin
