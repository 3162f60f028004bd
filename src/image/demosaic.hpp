// Demosaicing: computes all three colours of every pixel from the picture of a sensor with one colour per pixel.
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Returns an image with 3 channels. Each pixel keeps its measured colour. Negative values become 0. `mosaic` has 1 channel,
/// linear values, at least 3 x 3 pixels and a Bayer pattern. `red` is the position of the red pixel in the first 2 x 2 pixels:
/// both coordinates are 0 or 1.
Image demosaic(const Image& mosaic, Vec2i red);

}  // namespace lippmann
