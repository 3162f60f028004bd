// Converts films of sub-pixels (three side by side per pixel, for slanted panels) to pictures of pixels.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Each pixel takes red, green and blue from its first, second and third sub-pixel.
Image join_sub_pixels(const Image& film);

/// For layers other than colour: each pixel takes the value of its middle sub-pixel.
Image middle_sub_pixels(const Image& film);

}  // namespace lippmann
