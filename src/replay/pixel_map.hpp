// A picture whose pixels are pixels of another one: what conversions that never change a sample are made of.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/image/picture_file.hpp"

namespace lippmann {

/// Stands for no pixel: black.
inline constexpr std::uint32_t kNoPixel = 0xffffffffu;

/// Entry i is the pixel (row-major index) of the source that pixel i shows, or kNoPixel.
struct PixelMap {
  int width = 0, height = 0;
  std::vector<std::uint32_t> source;
};

Picture apply(const PixelMap& map, const Picture& picture);
Image apply(const PixelMap& map, const Image& picture);  ///< 3 channels

}  // namespace lippmann
