// Light of a lamp by direction, as a photometric web holds it (PhotometricWeb), and its sums over directions.
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Relative intensity in a unit direction of light's way, in the light's space: linear in polar angle and azimuth between what
/// was measured; 0 beyond, and where the direction is not finite.
float intensity(const PhotometricWeb& web, Vec3f direction);

/// Its mean over all directions, exact for what is linear in both angles.
double mean_intensity(const PhotometricWeb& web);

}  // namespace lippmann
