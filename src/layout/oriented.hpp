#pragma once

#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// Mirrors left to right, then rotates clockwise by 0, 90, 180 or 270 degrees.
Picture oriented(Picture picture, bool mirror, int turn_deg);

}  // namespace lippmann
