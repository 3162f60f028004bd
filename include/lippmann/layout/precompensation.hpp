// Statistics of correcting a picture in advance for light that a display leaks between neighbouring pixels
// (layout/precompensate.hpp).
#pragma once

namespace lippmann {

struct Precompensation {
  /// Fraction of samples that are clipped, because they would need light below black or above white.
  double clipped_share = 0.0;
  /// Largest difference between the picture that the eye sees and the intended one, in linear light (white is 1).
  double largest_residual = 0.0;

  bool operator==(const Precompensation&) const = default;
};

}  // namespace lippmann
