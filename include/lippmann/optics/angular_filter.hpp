// Angular filtering against aliasing between views: averages each view over all eye positions up to half-way to its neighbours.
//
// Beyond the depth budget, a point moves by more than a pixel from a view to the next. An eye between two views then sees the
// point twice. The filter blurs the point by that movement, so that both images merge. Lens arrays do not need the filter,
// because their samples spread over the directions of a pixel.
//
// Zwicker, Matusik, Durand, Pfister: Antialiasing for automultiscopic 3D displays, Eurographics Symposium on Rendering 2006. We
// deviate: instead of a Gaussian over position and angle, we sample a box over the angle, as wide as the view spacing.
#pragma once

#include <vector>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

enum class AngularFilter {
  kNone,
  kBox,  ///< a box as wide as the view spacing, along each axis with several eyes
};

/// Returns the eye shift of each sample of a pixel, in units of the view spacing (MultiView::eye_shift). Along each axis, the
/// shifts are the midpoints of `samples` equal parts of the box, in the order of the radical inverse (base 3 across, base 5
/// up). Their mean is zero. Returns a single zero shift if the filter does not apply.
std::vector<Vec2f> eye_shifts(const Optics& optics, AngularFilter filter, int samples);

/// Returns the optics with all eyes shifted. Optics other than MultiView stay unchanged.
Optics with_eyes_shifted(Optics optics, Vec2f shift);

}  // namespace lippmann
