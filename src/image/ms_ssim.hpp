// Computes the multi-scale structural similarity (MS-SSIM) that image/metrics.hpp defines.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Returns NaN if a side is below 161 pixels, because the window of 11 pixels must fit into the fifth scale, which has 1/16 of
/// the size (rounded up). Both images have one size.
double ms_ssim(const Image8& reference, const Image8& test);

}  // namespace lippmann
