// The height of the viewer's eyes above the middle of the display, as parameters give it.
#pragma once

#include "optics/optics_params.hpp"

namespace lippmann {

/// Returns the optics for eyes at that height; without one, as they are. Points of the plane z = 0 stay where they are. Throws
/// a usage Error for optics whose rows have no eye: microlens arrays, and viewers infinitely far away.
Optics with_eye_height(Optics optics, const std::optional<EyeHeight>& height);

/// Returns the millimetres of a height for eyes at that distance from the display.
float eye_height_mm(const EyeHeight& height, float distance_mm);

}  // namespace lippmann
