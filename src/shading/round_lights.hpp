// Lamps with a size: spheres, and suns as discs in the sky. From a given point, the directions to such a lamp form a cone,
// which is sampled uniformly.
//
// Based on: P. Shirley, C. Wang, K. Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", ACM Transactions on
// Graphics 15(1), 1996, section 3.3 (spheres by their solid angle).
//
// The radiance of a lamp is uniform:
// - Sphere: radiance = intensity / (pi radius^2). Its power and its unoccluded irradiance equal those of a point lamp.
// - Disc of half angle a: radiance = illuminance / (pi sin^2 a). A surface that faces the disc thus receives `illuminance`.
// - Inside a sphere, light comes from all directions, so the irradiance is intensity / radius^2 on every surface.
//
// Lamps do not block rays.
#pragma once

#include <optional>

#include "lippmann/core/math.hpp"
#include "shading/light_sample.hpp"
#include "shading/materials.hpp"

namespace lippmann {

struct RayPacket;

/// Returns whether a lamp is so large that it is not treated as a point. scene_size: half the scene's diagonal.
bool is_round(const WhittedLight& light, float scene_size);

/// Returns whether any ray of the packet may hit the lamp. Also counts rays of inactive lanes.
bool is_pointed_at(const WhittedLight& light, const RayPacket& rays);

/// Samples a direction to the lamp by `u`. The density in the result does not include the choice of the lamp. `unit` is a
/// factor on the colour, explained in light_table.hpp. Returns nothing if the point is out of range or the lamp does not emit
/// towards the point.
std::optional<LightSample> sample_round(const WhittedLight& light, float unit, Vec3f from, Vec2f u);

/// Evaluates the lamp along a ray of unit direction that has scattered at `from`. Returns nothing if the ray misses the lamp,
/// if `from` is out of range, or if the lamp does not emit towards `from`.
std::optional<LightSample> see_round(const WhittedLight& light, float unit, Vec3f from, Vec3f direction);

}  // namespace lippmann
