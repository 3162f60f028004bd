#pragma once

#include <cmath>
#include <cstdint>

#include "core/random.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann::test {

inline Image8 noise_codes(int width, int height, std::uint32_t seed = 1) {
  Image8 image{width, height, {}};
  image.rgb.resize(std::size_t{3} * width * height);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = hash(seed, static_cast<std::uint32_t>(i)) >> 24;
  return image;
}

inline Image8 smooth_codes(int width, int height, double phase = 0.0) {
  Image8 image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        image.rgb.push_back(
            static_cast<unsigned char>(128 + 90 * std::sin(0.05 * x + 0.8 * c + phase) * std::cos(0.04 * y - c)));
  return image;
}

inline Image noise_image(int width, int height, int channels, std::uint32_t seed = 1) {
  Image image(width, height, channels);
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = unit_float(hash(seed, static_cast<std::uint32_t>(i)));
  return image;
}

}  // namespace lippmann::test
