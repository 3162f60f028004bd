// Resizes images by area: each output pixel is the mean of the input area that it covers.
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Returns the image resized to `size`, which must be positive. The image may have any number of channels. If the size does not
/// change, the samples do not change either.
Image resampled(const Image& picture, Vec2i size);

}  // namespace lippmann
