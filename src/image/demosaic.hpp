// Demosaicing: computes all three colours of every pixel from the picture of a sensor with one colour per pixel.
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Returns an image with 3 channels and no negative values; each pixel keeps its measured colour. mosaic: 1 channel, linear, at
/// least 3 x 3 pixels, with a Bayer pattern (each 2 x 2 pixels have red, green twice, and blue). red: position of the red pixel
/// among the first 2 x 2 pixels; both coordinates are 0 or 1.
Image demosaic(const Image& mosaic, Vec2i red);

}  // namespace lippmann
