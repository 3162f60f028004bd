// Logarithm and powers that compilers can vectorise. Their errors are at most 1e-6.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/multiversion.hpp"

namespace lippmann {

/// Returns log2(x), exactly at powers of two. x must be positive and not denormal.
LIPPMANN_INLINE float fast_log2(float x) {
  const auto bits = std::bit_cast<std::int32_t>(x);
  // The exponent is chosen so that the mantissa m is in [sqrt(1/2), sqrt(2)).
  const std::int32_t exponent = (bits - 0x3f3504f3) >> 23;
  const float m = std::bit_cast<float>(bits - (exponent << 23));
  // log2(m) = 2 / ln 2 (s + s^3/3 + s^5/5 + ...) with s = (m - 1) / (m + 1), |s| < 0.172.
  const float s = (m - 1.0f) / (m + 1.0f), s2 = s * s;
  const float series = s * (2.885390082f + s2 * (0.961796694f + s2 * (0.577078016f + s2 * 0.412198583f)));
  return static_cast<float>(exponent) + series;
}

/// Returns 2^x for x < 127. x below -126 is clamped to -126.
LIPPMANN_INLINE float fast_exp2(float x) {
  const float clamped = x < -126.0f ? -126.0f : x;
  const float whole = std::floor(clamped + 0.5f);
  const float f = (clamped - whole) * 0.693147181f;  // the polynomial below is e^f, with |f| < 0.347
  const float p =
      1.0f + f * (1.0f + f * (0.5f + f * (0.166666667f + f * (0.0416666667f + f * (0.00833333333f + f * 0.00138888889f)))));
  return std::bit_cast<float>((static_cast<std::int32_t>(whole) + 127) << 23) * p;
}

/// Returns x^y. x must be positive and not denormal.
LIPPMANN_INLINE float fast_pow(float x, float y) { return fast_exp2(y * fast_log2(x)); }

}  // namespace lippmann
