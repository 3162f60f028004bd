// Statistics of precompensating a picture for a display's crosstalk (layout/precompensate.hpp).
#pragma once

namespace lippmann {

struct Precompensation {
  /// Share of samples that are clipped, because compensation would need light below black or above white.
  double clipped_share = 0.0;
  /// Largest difference between the picture that the eye sees and the intended one, in linear light (white is 1).
  double largest_residual = 0.0;

  bool operator==(const Precompensation&) const = default;
};

}  // namespace lippmann
