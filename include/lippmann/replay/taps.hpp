// Interpolation weights along one axis of an image.
#pragma once

#include "lippmann/optics/crosstalk.hpp"

namespace lippmann {

enum class SampleFilter {
  kNearest,  ///< takes the pixel that contains the point
  kLinear,   ///< mixes the two pixels with the nearest centres, weighted by distance
};

/// Returns the pixels and weights at a position. Pixel i covers i ... i + 1. Indices may lie outside the image.
Taps taps_at(double position_px, SampleFilter filter);

}  // namespace lippmann
