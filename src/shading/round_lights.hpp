// Lamps that have a size: spheres, and suns that are discs in the sky. Seen from a point, each is a cone of directions, and it
// is sampled uniformly by them.
//
// Based on: P. Shirley, C. Wang, K. Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", ACM Transactions on
// Graphics 15(1), 1996, section 3.3 (spheres by their solid angle).
//
// Their radiance is uniform: intensity / (pi radius^2) of spheres, so that their power, and the irradiance of points in sight
// of all of them, are those of the point; illuminance / (pi sin^2 a) of discs of half angle a, so that a surface that faces the
// disc has that illuminance. Within a sphere it comes from all around: intensity / radius^2 on every surface, as on the sphere.
// They are light alone: no ray ends at them.
#pragma once

#include <optional>

#include "lippmann/core/math.hpp"
#include "shading/light_sample.hpp"
#include "shading/materials.hpp"

namespace lippmann {

struct RayPacket;

/// Whether a lamp's size counts: smaller ones are points. scene_size: half its diagonal.
bool is_round(const WhittedLight& light, float scene_size);

/// Whether any ray of the packet may see it, lanes that are not active included.
bool is_pointed_at(const WhittedLight& light, const RayPacket& rays);

/// A light from within its directions, chosen by `u`; its density is that of the direction alone. `unit`: a factor on its
/// colour, explained in light_table.hpp. None where the point is out of reach, or the direction is one that the lamp does not
/// shine in.
std::optional<LightSample> sample_round(const WhittedLight& light, float unit, Vec3f from, Vec2f u);

/// The same for the light that a ray of unit direction sees, which has scattered at `from`.
std::optional<LightSample> see_round(const WhittedLight& light, float unit, Vec3f from, Vec3f direction);

}  // namespace lippmann
