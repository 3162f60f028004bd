// An image whose pixels are copies of another image's pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/image/picture_file.hpp"

namespace lippmann {

inline constexpr std::uint32_t kNoPixel = 0xffffffffu;

/// source[i] is the row-major index of the pixel that pixel i copies, or kNoPixel for black.
struct PixelMap {
  int width = 0, height = 0;
  std::vector<std::uint32_t> source;
};

Picture apply(const PixelMap& map, const Picture& picture);
Image apply(const PixelMap& map, const Image& picture);

}  // namespace lippmann
