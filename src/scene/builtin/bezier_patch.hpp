// Bicubic Bezier patches: points, exact normals and triangles.
#pragma once

#include <array>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

/// points[row][column]; u runs along a row, v from row to row.
using BezierPatch = std::array<std::array<Vec3f, 4>, 4>;

Vec3f point_on(const BezierPatch& patch, float u, float v);

/// The unit vector along dP/du x dP/dv; where one of them vanishes (an edge that is a single point), its limit.
Vec3f normal_on(const BezierPatch& patch, float u, float v);

/// Adds (steps + 1)^2 vertices and up to 2 steps^2 triangles; triangles without area (at an edge that is a point) are left out.
/// Front sides face along the normal. uvs are (u, v).
void tessellate(const BezierPatch& patch, int steps, Mesh& mesh);

}  // namespace lippmann::builtin
