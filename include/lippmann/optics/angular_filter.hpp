// Angular filtering against aliasing between views: averages each view over all eye positions up to half-way to its neighbours.
//
// Beyond the depth budget, neighbouring views differ by more than a pixel, and a display that moves from one view to the next
// shows points twice. With the filter such points blur by exactly the distance between views, while points in the plane z = 0
// stay sharp. Lens arrays do not need it: samples spread over a pixel's area are also spread over its directions.
//
// Zwicker, Matusik, Durand, Pfister: Antialiasing for automultiscopic 3D displays, Eurographics Symposium on Rendering 2006.
// Unlike the paper, we use a box as wide as the view spacing, by sampling, instead of a Gaussian over both domains.
#pragma once

#include <vector>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

enum class AngularFilter {
  kNone,
  kBox,  ///< a box as wide as the view spacing: across for a cone of views, across and up for a camera grid
};

/// Returns the eye shifts of a pixel's samples, in units of the view spacing (MultiView::eye_shift). They are the midpoints of
/// equal parts of the box, ordered by radical inverse (base 3 across, 5 up), so that their mean is zero and consecutive samples
/// are far apart. Returns a single zero shift if the filter does not apply.
std::vector<Vec2f> eye_shifts(const Optics& optics, AngularFilter filter, int samples);

/// Returns the optics with all eyes shifted. Optics other than MultiView stay unchanged.
Optics with_eyes_shifted(Optics optics, Vec2f shift);

}  // namespace lippmann
