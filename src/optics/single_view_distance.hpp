// Moves the eye of a single view.
#pragma once

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns the optics with the eye at a distance from the plane z = 0. Optics other than a single view stay unchanged.
Optics with_single_view_distance(Optics optics, float distance_mm);

}  // namespace lippmann
