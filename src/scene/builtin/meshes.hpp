// Meshes of simple curved things: surfaces of revolution, tubes along curves, discs, rectangles; with unit normals and uvs.
//
// All surfaces are seen from outside: triangles run counter-clockwise there and normals point there. No triangle has zero
// area: where a surface closes at a pole, the triangles that would collapse are left out.
#pragma once

#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

/// Adds a placed copy of `part`. Both have normals and uvs, or both lack them; `placement` keeps proportions.
void append(Mesh& mesh, const Mesh& part, const Affine3f& placement = {});

/// A surface of revolution about y. `profile` holds (radius, y) points; walked along it, the outside is on the right-hand side
/// (bottom to top for the outside of a vase). A point given twice is a crease, else normals are smooth. u runs once around,
/// v from 1 at the first point to 0 at the last one.
Mesh lathe(const std::vector<Vec2f>& profile, int segments);

/// A smooth profile through the given points (Catmull-Rom), `steps` pieces between neighbours. A point given twice stays a
/// crease.
std::vector<Vec2f> smooth_profile(const std::vector<Vec2f>& points, int steps);

/// A tube around a curve: `points` are its centres, radii one per point. A closed curve does not repeat its first point. Open
/// ends are not capped. u runs once around, v once along.
Mesh tube(const std::vector<Vec3f>& points, const std::vector<float>& radii, int sides, bool closed);

/// A ring-shaped tube about y.
Mesh torus(float major_radius, float minor_radius, int segments, int sides);

/// A cone with its base disc, which lies in y = 0.
Mesh cone(float radius, float height, int segments);

/// A ball; u once around y, v from 0 at the top to 1 at the bottom.
Mesh uv_sphere(float radius, int segments, int rings);

/// A flat disc in y = 0, facing +y; uvs are (x, z) / uv_size.
Mesh disc(float radius, int segments, float uv_size);

/// A rectangle around `center`, spanned by two half edges, facing cross(half_u, half_v); uvs run from (0, repeats.y) at
/// center - half_u - half_v to (repeats.x, 0) at the opposite corner.
Mesh rectangle(Vec3f center, Vec3f half_u, Vec3f half_v, Vec2f repeats = Vec2f(1.0f));

/// Splits vertices at edges where the faces meet at more than `crease_angle` and gives every vertex the mean normal, weighted
/// by area, of the faces that it then belongs to. Vertices are told apart by index: weld the mesh first. uvs are dropped.
Mesh with_creases(const Mesh& welded, float crease_angle);

}  // namespace lippmann::builtin
