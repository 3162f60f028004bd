#pragma once

#include <numbers>

namespace lippmann {

/// from_degrees(to_degrees(x)) equals x exactly.
inline constexpr double to_degrees(float radians) { return static_cast<double>(radians) * (180.0 / std::numbers::pi); }
inline constexpr float from_degrees(double degrees) { return static_cast<float>(degrees * (std::numbers::pi / 180.0)); }

}  // namespace lippmann
