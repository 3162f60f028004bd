// Angles as files have them: in degrees, with so many digits that they are read as the same floats.
#pragma once

#include <numbers>

namespace lippmann {

/// from_degrees(to_degrees(x)) is x, to the bit.
inline constexpr double to_degrees(float radians) { return static_cast<double>(radians) * (180.0 / std::numbers::pi); }
inline constexpr float from_degrees(double degrees) { return static_cast<float>(degrees * (std::numbers::pi / 180.0)); }

}  // namespace lippmann
