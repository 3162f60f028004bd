// Structural similarity of two pictures; defined in image/metrics.hpp.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Pictures of one size. Not a number if a side is below 11 pixels.
double ssim(const Image8& reference, const Image8& test);

}  // namespace lippmann
