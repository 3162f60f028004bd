// Demosaicing: computes all colours of every pixel from a sensor with one colour per pixel.
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Returns 3 channels without negative values; the measured colour of each pixel is kept. mosaic: 1 channel, linear, at least 3
/// x 3 pixels, a Bayer pattern with red, green twice and blue in each 2 x 2 pixels. red: position of the red pixel among the
/// first 2 x 2, each coordinate 0 or 1.
Image demosaic(const Image& mosaic, Vec2i red);

}  // namespace lippmann
