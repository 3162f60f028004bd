// Lamps with a size: spheres, and suns as discs in the sky. The directions from a point to such a lamp form a cone, which is
// sampled uniformly.
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

bool is_round(const WhittedLight& light, float scene_size);

bool is_pointed_at(const WhittedLight& light, const RayPacket& rays);

/// Samples a direction to the lamp by `u`. The density does not include the choice of the lamp. `unit` converts the lamp's
/// colour to irradiance: pi if the scene has Phong surfaces, otherwise 1. Returns nothing if the point is out of range or the
/// lamp does not emit towards the point.
std::optional<LightSample> sample_round(const WhittedLight& light, float unit, Vec3f from, Vec2f u);

/// Returns the light along a ray of unit direction from `from`, or nothing if the ray misses the lamp or no light arrives.
std::optional<LightSample> see_round(const WhittedLight& light, float unit, Vec3f from, Vec3f direction);

}  // namespace lippmann
