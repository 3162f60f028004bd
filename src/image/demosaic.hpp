// Colours of every pixel from a sensor that sees one colour per pixel.
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// `mosaic`: 1 channel, linear, at least 3 x 3 pixels; each 2 x 2 pixels see red, green twice, and blue. `red`: the place of
/// the red pixel among the first 2 x 2, each 0 or 1. Returns 3 channels, none below 0; what a pixel sees itself is kept.
Image demosaic(const Image& mosaic, Vec2i red);

}  // namespace lippmann
