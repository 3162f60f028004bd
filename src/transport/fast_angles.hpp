// Trigonometric functions that compilers can vectorise. Their errors are at most 3e-7.
//
// The polynomials for arc tangent and arc sine are minimax approximations (E. Remez, 1934).
#pragma once

#include <cmath>

#include "core/multiversion.hpp"
#include "lippmann/core/math.hpp"

namespace lippmann {

/// Returns std::atan2(y, x), but ignores the sign of zeros.
LIPPMANN_INLINE float fast_atan2(float y, float x) {
  const float ax = std::abs(x), ay = std::abs(y);
  const bool flat = ax >= ay;
  const float larger = flat ? ax : ay, smaller = flat ? ay : ax;
  const float t = smaller / (larger > 0.0f ? larger : 1.0f), z = t * t;
  const float p =
      -0.333329871f +
      z * (0.199903966f +
           z * (-0.141859753f +
                z * (0.105739321f + z * (-0.073667062f + z * (0.041121861f + z * (-0.0151325369f + z * 0.00262224472f))))));
  const float first = t + t * z * p;
  const float quadrant = flat ? first : 0.5f * kPi - first;
  const float half = x < 0.0f ? kPi - quadrant : quadrant;
  return y < 0.0f ? -half : half;
}

LIPPMANN_INLINE float fast_acos(float x) {
  const float a = std::abs(x);
  const bool steep = a > 0.5f;  // arccos x = 2 arcsin sqrt((1 - x) / 2)
  const float z = steep ? 0.5f * (1.0f - a) : a * a, s = steep ? std::sqrt(z) : a;
  const float p = 0.166668215f + z * (0.0749307718f + z * (0.0457077875f + z * (0.0231422849f + z * 0.0437630404f)));
  const float arcsine = s + s * z * p;
  const float of_a = steep ? 2.0f * arcsine : 0.5f * kPi - arcsine;
  return x < 0.0f ? kPi - of_a : of_a;
}

/// Computes sine and cosine of an angle of at most a few turns.
LIPPMANN_INLINE void fast_sin_cos(float angle, float& sine, float& cosine) {
  const float quarters = std::floor(angle * (2.0f / kPi) + 0.5f);
  // pi / 2 is split into two numbers, so that products with the first number are exact.
  const float x = (angle - quarters * 1.5703125f) - quarters * 4.83826795e-4f, z = x * x;
  const float s = x + x * z * (-0.16666651f + z * (0.008331979f + z * -0.00019495636f));
  const float c = 1.0f - 0.5f * z + z * z * (0.041666646f + z * (-0.0013887368f + z * 2.4438452e-05f));
  const int quarter = static_cast<int>(quarters) & 3;
  const bool is_odd = (quarter & 1) != 0;
  const float a = is_odd ? c : s, b = is_odd ? s : c;
  sine = (quarter & 2) != 0 ? -a : a;
  cosine = ((quarter + 1) & 2) != 0 ? -b : b;
}

}  // namespace lippmann
