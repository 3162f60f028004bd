// Shows where two pictures differ.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

/// min(255, gain |a - b|) per code: black where they agree. Pictures of one size.
Image8 difference_picture(const Image8& a, const Image8& b, int gain = 1);

}  // namespace lippmann
