// Which pixels of one axis make a sample at a point between them, and how much each.
#pragma once

#include <array>

namespace lippmann {

enum class SampleFilter {
  kNearest,  ///< the pixel that holds the point
  kLinear,   ///< the two whose centres are nearest, by distance
};

inline constexpr double kMaxBlurPx = 8.0;

struct Tap {
  int index;
  double weight;
};

/// Uninitialised beyond `count`.
struct Taps {
  std::array<Tap, 84> tap;
  int count = 0;

  void add(int index, double weight) { tap[static_cast<std::size_t>(count++)] = {index, weight}; }
  const Tap* begin() const { return tap.data(); }
  const Tap* end() const { return tap.data() + count; }
};

/// Pixel i covers i ... i + 1. Indices may lie outside any picture.
Taps taps_at(double position_px, SampleFilter filter);

/// A Gaussian of `sigma_px`, 0 < sigma <= kMaxBlurPx, cut off at 4 sigma and integrated over each pixel: for sigma -> 0 it is
/// the nearest pixel.
Taps gaussian_taps(double position_px, double sigma_px);

}  // namespace lippmann
