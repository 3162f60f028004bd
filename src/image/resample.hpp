// Pictures in another size: every new pixel is the mean of what it covers of the old ones, by area.
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Any number of channels; sides above 0. The same size gives the same picture, half the size the mean of two pixels.
Image resampled(const Image& picture, Vec2i size);

}  // namespace lippmann
