// Multi-scale structural similarity; defined in image/metrics.hpp.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Returns the MS-SSIM of two images of one size. NaN if a side is below 161 pixels, since the window does not fit into the
/// fifth scale.
double ms_ssim(const Image8& reference, const Image8& test);

}  // namespace lippmann
