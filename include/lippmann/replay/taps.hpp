// Which pixels of one axis make a sample at a point between them, and how much each.
#pragma once

#include "lippmann/optics/crosstalk.hpp"

namespace lippmann {

enum class SampleFilter {
  kNearest,  ///< the pixel that holds the point
  kLinear,   ///< the two whose centres are nearest, by distance
};

/// Pixel i covers i ... i + 1. Indices may lie outside any picture.
Taps taps_at(double position_px, SampleFilter filter);

}  // namespace lippmann
