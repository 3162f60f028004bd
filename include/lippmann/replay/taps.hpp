// Interpolation weights along one axis of an image.
#pragma once

#include "lippmann/optics/crosstalk.hpp"

namespace lippmann {

enum class SampleFilter {
  kNearest,  ///< the pixel that contains the point
  kLinear,   ///< the two pixels with the nearest centres, weighted by distance
};

/// Returns the weights of the pixels at a position in continuous pixel coordinates, where pixel i covers [i, i + 1). Indices of
/// pixels may lie outside the image.
Taps taps_at(double position_px, SampleFilter filter);

}  // namespace lippmann
