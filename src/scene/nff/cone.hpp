// Makes the side of a cone or a truncated cone as a mesh.
#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann::nff {

/// Sides of the polygonal outline, which deviates from the circle by r (1 - cos(pi / 64)) = 0.12 % of the radius.
inline constexpr int kConeSides = 64;

/// Adds triangles with smooth normals that face outwards. base != apex; radii >= 0, not both 0. The mesh must have normals.
void add_cone(Mesh& mesh, Vec3f base, float base_radius, Vec3f apex, float apex_radius);

}  // namespace lippmann::nff
