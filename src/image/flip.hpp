// LDR-FLIP, the perceived difference between two alternating images; defined in image/metrics.hpp.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Returns the mean FLIP over all pixels of two sRGB images of one size, seen at 67 pixels per degree: 0 (equal) ... 1.
double flip(const Image8& reference, const Image8& test);

}  // namespace lippmann
