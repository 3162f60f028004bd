#pragma once

#include "optics/optics_params.hpp"

namespace lippmann {

/// Returns the optics for eyes at a height, or unchanged optics if no height is given. Points of the plane z = 0 keep their
/// pixels. Throws a usage Error for optics without an eye height: microlens arrays, and optics with an infinitely distant
/// viewer.
Optics with_eye_height(Optics optics, const std::optional<EyeHeight>& height);

float eye_height_mm(const EyeHeight& height, float distance_mm);

}  // namespace lippmann
