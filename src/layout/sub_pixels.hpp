// Films of sub-pixels, three in a row for every pixel (optics/optics.hpp: slanted panels), as pictures of pixels.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Colours: each pixel takes red, green and blue from the first, second and third of its sub-pixels.
Image join_sub_pixels(const Image& film);

/// Other layers: each pixel takes what its middle sub-pixel has.
Image middle_sub_pixels(const Image& film);

}  // namespace lippmann
