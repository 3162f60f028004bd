// Converts films of sub-pixels (three side by side per pixel, for slanted panels in optics/optics.hpp) to pictures of pixels.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Converts a film of colours: each pixel takes red, green and blue from its first, second and third sub-pixel.
Image join_sub_pixels(const Image& film);

/// Converts layers other than colour: each pixel takes the value of its middle sub-pixel.
Image middle_sub_pixels(const Image& film);

}  // namespace lippmann
