// Views that are averages of what is seen from all places between one eye and the next, rather than from one place each.
//
// Where neighbouring views are more than a pixel apart, beyond the depth budget, a display that passes from view to view shows
// such points twice. Seen from half-way to one neighbour to half-way to the other they blur instead, by just the distance from
// view to view; what lies in the plane z = 0 is the same from everywhere and stays as sharp as it is. Pixels below lenses need
// none of this: samples that are spread over a pixel's area are spread over its directions.
//
// Zwicker, Matusik, Durand, Pfister: Antialiasing for automultiscopic 3D displays, Eurographics Symposium on Rendering 2006.
// We deviate: a box as wide as a view, by samples, in place of a Gaussian over both domains.
#pragma once

#include <vector>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

enum class AngularFilter {
  kNone,
  kBox,  ///< as wide as from eye to eye: of a cone across, of a camera grid across and up
};

/// How the eyes of the samples of every pixel are moved, in steps from view to view (MultiView::eye_shift): to the middles of
/// as many equal parts of the box, in the order of radical inverses (base 3 across, 5 up), so that their mean is the eye itself
/// and samples that follow one another are far apart. One, and it is not moved, where nothing is spread.
std::vector<Vec2f> eye_shifts(const Optics& optics, AngularFilter filter, int samples);

/// No effect on other optics than views.
Optics with_eyes_shifted(Optics optics, Vec2f shift);

}  // namespace lippmann
