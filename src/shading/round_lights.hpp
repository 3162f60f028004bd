// Lamps with a size: spheres, and suns as discs in the sky. From a point, each is a cone of directions, which is sampled
// uniformly.
//
// Based on: P. Shirley, C. Wang, K. Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", ACM Transactions on
// Graphics 15(1), 1996, section 3.3 (spheres by their solid angle).
//
// The radiance is uniform. Spheres have intensity / (pi radius^2), so their power and unoccluded irradiance equal those of the
// point lamp. Discs of half angle a have illuminance / (pi sin^2 a), so a surface that faces the disc receives that
// illuminance. Inside a sphere, light comes from all directions: the irradiance is intensity / radius^2 on every surface, as on
// the sphere. Lamps do not block rays.
#pragma once

#include <optional>

#include "lippmann/core/math.hpp"
#include "shading/light_sample.hpp"
#include "shading/materials.hpp"

namespace lippmann {

struct RayPacket;

/// Returns whether a lamp's size matters; smaller lamps are points. scene_size: half the scene's diagonal.
bool is_round(const WhittedLight& light, float scene_size);

/// Returns whether any ray of the packet may hit the lamp, including inactive lanes.
bool is_pointed_at(const WhittedLight& light, const RayPacket& rays);

/// Samples a direction to the lamp by `u`. The density is that of the direction only. `unit`: factor on the colour, explained
/// in light_table.hpp. Returns nothing if the point is out of range or the lamp does not emit towards it.
std::optional<LightSample> sample_round(const WhittedLight& light, float unit, Vec3f from, Vec2f u);

/// Evaluates the lamp along a ray of unit direction that has scattered at `from`. Otherwise like sample_round().
std::optional<LightSample> see_round(const WhittedLight& light, float unit, Vec3f from, Vec3f direction);

}  // namespace lippmann
