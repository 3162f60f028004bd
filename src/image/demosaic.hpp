// Computes all three colours of every pixel from a sensor with one colour per pixel.
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Returns 3 channels. Negative values become 0. `mosaic` has 1 channel, linear values, at least 3 x 3 pixels and a Bayer
/// pattern. `red` is the position of the red pixel among the first 2 x 2.
Image demosaic(const Image& mosaic, Vec2i red);

}  // namespace lippmann
