#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann::nff {

/// Number of sides of the polygon that approximates the circle. It deviates from the circle by 1 - cos(pi / 64) = 0.12 % of the
/// radius.
inline constexpr int kConeSides = 64;

/// Adds triangles with smooth normals that face outwards. The base must differ from the apex. Radii must be >= 0, and one of
/// them > 0. The mesh must have normals.
void add_cone(Mesh& mesh, Vec3f base, float base_radius, Vec3f apex, float apex_radius);

}  // namespace lippmann::nff
