// Computes the multi-scale structural similarity (MS-SSIM) that image/metrics.hpp defines.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Returns NaN if a side is below 161 pixels, because the window of 11 pixels does not fit into the fifth scale. Both images
/// have one size.
double ms_ssim(const Image8& reference, const Image8& test);

}  // namespace lippmann
