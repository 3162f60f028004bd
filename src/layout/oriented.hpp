// Mirrors and rotates pictures, for prints and videos.
#pragma once

#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// Returns the picture mirrored left to right, then rotated clockwise by 0, 90, 180 or 270 degrees.
Picture oriented(Picture picture, bool mirror, int turn_deg);

}  // namespace lippmann
