// Resizes images by area: each output pixel is the mean of the input area that it covers.
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Returns the image resized to `size`, > 0, with any number of channels. If the size stays equal, the samples stay unchanged;
/// for half the size, two pixels are averaged along each axis.
Image resampled(const Image& picture, Vec2i size);

}  // namespace lippmann
