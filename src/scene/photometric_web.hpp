#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Returns the relative intensity of the light that leaves the lamp in `direction`, a unit vector in the light's coordinates.
/// Returns 0 outside the measured range and for directions that are not finite.
float intensity(const PhotometricWeb& web, Vec3f direction);

/// Returns the mean intensity over the sphere.
double mean_intensity(const PhotometricWeb& web);

}  // namespace lippmann
