// The perceived difference of two pictures that are shown in turn (LDR-FLIP); defined in image/metrics.hpp.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

/// The mean over all pixels of FLIP for pictures of sRGB codes that are seen at 67 pixels per degree: 0 (equal) ... 1. The
/// pictures must have one size.
double flip(const Image8& reference, const Image8& test);

}  // namespace lippmann
