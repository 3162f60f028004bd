// Converts films of sub-pixels, three per pixel in a row (slanted panels in optics/optics.hpp), to pictures of pixels.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Joins colours: each pixel takes red, green and blue from its first, second and third sub-pixel.
Image join_sub_pixels(const Image& film);

/// Joins other layers: each pixel takes the value of its middle sub-pixel.
Image middle_sub_pixels(const Image& film);

}  // namespace lippmann
