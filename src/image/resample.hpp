// Resizes images by area: each output pixel is the mean of the input area that it covers.
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Returns the image with the given size, > 0. Any number of channels. An equal size copies the image; half the size averages
/// two pixels.
Image resampled(const Image& picture, Vec2i size);

}  // namespace lippmann
