// Meshes of simple curved shapes, with unit normals and uvs: surfaces of revolution, tubes along curves, discs, rectangles.
//
// Triangles are counter-clockwise seen from outside, and normals point outwards. No triangle has zero area: collapsed triangles
// at poles are skipped.
#pragma once

#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

/// Adds a transformed copy of `part`. Normals and uvs must exist in both meshes or in neither. `placement` must scale
/// uniformly.
void append(Mesh& mesh, const Mesh& part, const Affine3f& placement = {});

/// Returns a surface of revolution about y. `profile` holds (radius, y) points, with the outside to the right of its direction
/// (bottom to top for the outside of a vase). A repeated point makes a crease; elsewhere normals are smooth. u runs once around
/// the axis, v from 1 at the first point to 0 at the last one.
Mesh lathe(const std::vector<Vec2f>& profile, int segments);

/// Returns a smooth profile through the given points (Catmull-Rom) with `steps` segments between neighbours. Repeated points
/// become creases.
std::vector<Vec2f> smooth_profile(const std::vector<Vec2f>& points, int steps);

/// Returns a tube around a curve with centres `points` and one radius per point. Closed curves do not repeat their first point.
/// Open ends are not capped. u runs once around the tube, v once along it.
Mesh tube(const std::vector<Vec3f>& points, const std::vector<float>& radii, int sides, bool closed);

/// Returns a torus about y.
Mesh torus(float major_radius, float minor_radius, int segments, int sides);

/// Returns a cone with its base disc in y = 0.
Mesh cone(float radius, float height, int segments);

/// Returns a sphere. u runs once around y, v from 0 at the top to 1 at the bottom.
Mesh uv_sphere(float radius, int segments, int rings);

/// Returns a flat disc in y = 0, facing +y; uvs are (x, z) / uv_size.
Mesh disc(float radius, int segments, float uv_size);

/// Returns a rectangle around `center`, spanned by two half edges, facing cross(half_u, half_v). uvs run from (0, repeats.y) at
/// center - half_u - half_v to (repeats.x, 0) at the opposite corner.
Mesh rectangle(Vec3f center, Vec3f half_u, Vec3f half_v, Vec2f repeats = Vec2f(1.0f));

/// Splits vertices at edges where faces meet at more than `crease_angle`, and gives every vertex the area-weighted mean normal
/// of its faces. Vertices are identified by index, so the mesh must be welded. Drops uvs.
Mesh with_creases(const Mesh& welded, float crease_angle);

}  // namespace lippmann::builtin
