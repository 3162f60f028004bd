// Bicubic Bezier patches: points, exact normals and triangles.
#pragma once

#include <array>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

/// The control points, as points[row][column]. u runs along a row, v from row to row.
using BezierPatch = std::array<std::array<Vec3f, 4>, 4>;

Vec3f point_on(const BezierPatch& patch, float u, float v);

/// Returns the unit vector along dP/du x dP/dv, or its limit if one of them vanishes (at an edge that is a single point).
Vec3f normal_on(const BezierPatch& patch, float u, float v);

/// Adds (steps + 1)^2 vertices and up to 2 steps^2 triangles. Skips triangles without area, which occur at edges that are
/// single points. Triangles are counter-clockwise seen from the side of the normal. uvs are (u, v).
void tessellate(const BezierPatch& patch, int steps, Mesh& mesh);

}  // namespace lippmann::builtin
