// Grey images for comparisons, with 8-bit codes, row-major from the top left.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann {

struct GreyPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> codes;
};

/// Returns the mean of the channels' sRGB codes. If a side is longer than `longest` pixels, the image is reduced.
GreyPicture grey_of(const Picture& picture, int longest);

}  // namespace lippmann
