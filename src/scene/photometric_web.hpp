// Evaluates the angular distribution of a lamp (PhotometricWeb).
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Returns the relative intensity in a unit direction of light propagation in light space, interpolated linearly in polar angle
/// and azimuth. Returns 0 outside the measured range and for directions that are not finite.
float intensity(const PhotometricWeb& web, Vec3f direction);

/// Returns the mean over all directions, exact for the interpolated distribution.
double mean_intensity(const PhotometricWeb& web);

}  // namespace lippmann
