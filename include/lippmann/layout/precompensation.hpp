// Statistics of precompensating a picture for a display's crosstalk (layout/precompensate.hpp).
#pragma once

namespace lippmann {

struct Precompensation {
  double clipped_share =
      0.0;  ///< share of samples clipped because they would need to be darker than black or brighter than white
  double largest_residual = 0.0;  ///< largest difference between the picture as seen and as intended; linear light, 1 is white

  bool operator==(const Precompensation&) const = default;
};

}  // namespace lippmann
