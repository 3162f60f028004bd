#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "lippmann/core/error.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

inline constexpr int kMaxSide = 1 << 16;  ///< maximum side of a panel in pixels; up to this size, floats resolve 1/256 pixel
/// Limits of lengths in mm. Within these limits, squares and quotients of lengths do not overflow floats.
inline constexpr float kMinLength = 1e-6f, kMaxLength = 1e9f;

[[noreturn]] inline void reject_field(const char* field, const std::string& problem, const std::string& accepted) {
  throw usage_error(field, problem, accepted);
}

inline void check_count(const char* field, int value, int maximum) {
  if (value < 1 || value > maximum)
    reject_field(field, fmt::format("is {}", value), fmt::format("a whole number from 1 to {}", maximum));
}

inline void check_length(const char* field, float value) {
  if (!(value >= kMinLength && value <= kMaxLength))
    reject_field(field, fmt::format("is {} mm", value), fmt::format("a length from {} to {} mm", kMinLength, kMaxLength));
}

inline void check_distance_or_infinity(const char* field, float value) {
  if (value == kInfinity) return;
  if (!(value >= kMinLength && value <= kMaxLength))
    reject_field(field, fmt::format("is {} mm", value),
                 fmt::format("a distance from {} to {} mm, or inf", kMinLength, kMaxLength));
}

inline void check_position(const char* field, float value) {
  if (!(std::abs(value) <= kMaxLength))
    reject_field(field, fmt::format("is {} mm", value), fmt::format("a position within {} mm of the centre", kMaxLength));
}

/// Checks that a lens is at least one pixel wide. The factor 0.999 allows for rounding errors.
inline void check_lens(const char* field, float lens_pitch_mm, const Panel& panel) {
  check_length(field, lens_pitch_mm);
  if (lens_pitch_mm < 0.999f * panel.pixel_pitch_mm)
    reject_field(field, fmt::format("is {} mm, less than one pixel", lens_pitch_mm),
                 fmt::format("at least the pixel pitch, {} mm", panel.pixel_pitch_mm));
}

inline void check_number(const char* field, double value, double low, double high) {
  if (!(value >= low && value <= high))
    reject_field(field, fmt::format("is {}", value), fmt::format("a number from {} to {}", low, high));
}

inline void check_parallax(const char* field, float value) {
  if (!(value > 0.0f && std::isfinite(value))) reject_field(field, fmt::format("is {}", value), "a number above 0");
}

inline void check_cone(const char* field, float cone) {
  if (!(cone >= 0.0f && cone <= radians(179.0f)))
    reject_field(field, fmt::format("is {} degrees", degrees(cone)), "an angle from 0 to 179 degrees");
}

}  // namespace lippmann
