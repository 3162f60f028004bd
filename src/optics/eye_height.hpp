// Applies a height of the viewer's eyes above the middle of the display to optics.
#pragma once

#include "optics/optics_params.hpp"

namespace lippmann {

/// Returns the optics for eyes at this height, unchanged if there is none. Points of the plane z = 0 keep their pixels. Throws
/// a usage Error for optics that have no eye height: microlens arrays, and infinitely distant viewers.
Optics with_eye_height(Optics optics, const std::optional<EyeHeight>& height);

/// Returns the height in mm for eyes at this distance from the display.
float eye_height_mm(const EyeHeight& height, float distance_mm);

}  // namespace lippmann
