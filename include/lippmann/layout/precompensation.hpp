// What undoing a display's crosstalk (layout/precompensate.hpp) cost a picture.
#pragma once

namespace lippmann {

struct Precompensation {
  double clipped_share = 0.0;     ///< share of samples that would have to be darker than black or brighter than white
  double largest_residual = 0.0;  ///< how far what is seen is from what was wanted, at worst; linear light, 1 is white

  bool operator==(const Precompensation&) const = default;
};

}  // namespace lippmann
