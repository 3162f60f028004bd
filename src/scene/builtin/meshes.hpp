// Meshes of simple curved shapes, with unit normals and texture coordinates.
//
// Triangles are counter-clockwise from outside, and normals point outwards. No triangle has zero area.
#pragma once

#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

/// Adds a copy of `part`. Either both meshes have normals and uvs, or neither does. `placement` must scale uniformly.
void append(Mesh& mesh, const Mesh& part, const Affine3f& placement = {});

/// Returns a surface of revolution about the y axis. `profile` lists points (radius, y), with the outside to the right of its
/// direction. Normals are smooth, except at a crease, which is a point listed twice. u runs once around the axis. v runs from 1
/// at the first point to 0 at the last point.
Mesh lathe(const std::vector<Vec2f>& profile, int segments);

/// Returns a smooth (Catmull-Rom) profile through the points, with `steps` segments between neighbouring points. Points listed
/// twice remain creases.
std::vector<Vec2f> smooth_profile(const std::vector<Vec2f>& points, int steps);

/// Returns a tube around the curve through `points`, with one radius per point. For a closed curve, do not repeat the first
/// point at the end. The ends of an open tube are not capped. u runs once around the tube, v once along it.
Mesh tube(const std::vector<Vec3f>& points, const std::vector<float>& radii, int sides, bool closed);

Mesh torus(float major_radius, float minor_radius, int segments, int sides);

Mesh cone(float radius, float height, int segments);

/// Returns a sphere. u runs once around the y axis. v runs from 0 at the top to 1 at the bottom.
Mesh uv_sphere(float radius, int segments, int rings);

/// Returns a flat disc in the plane y = 0 that faces +y. The uvs are (x, z) / uv_size.
Mesh disc(float radius, int segments, float uv_size);

/// Returns a rectangle around `center`, spanned by two half edges. It faces along cross(half_u, half_v). uv is (0, repeats.y)
/// at center - half_u - half_v, and (repeats.x, 0) at the opposite corner.
Mesh rectangle(Vec3f center, Vec3f half_u, Vec3f half_v, Vec2f repeats = Vec2f(1.0f));

/// Returns the mesh with area-weighted normals. Vertices are split at edges where the angle between faces exceeds
/// `crease_angle` radians. Faces that meet must share vertex indices. The result has no uvs.
Mesh with_creases(const Mesh& welded, float crease_angle);

}  // namespace lippmann::builtin
