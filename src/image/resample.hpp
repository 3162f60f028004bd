// Resizes images by area: each output pixel is the mean of the input area that it covers.
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// `size` must be positive; `picture` may have any number of channels. Samples do not change if the size does not.
Image resampled(const Image& picture, Vec2i size);

}  // namespace lippmann
