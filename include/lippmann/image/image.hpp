// Images in memory: row-major from the top left, with interleaved channels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lippmann {

struct Image {
  int width = 0, height = 0, channels = 3;
  std::vector<float> data;  ///< channel c at (x, y): data[(y * width + x) * channels + c]

  Image() = default;
  Image(int w, int h, int c) : width(w), height(h), channels(c), data(static_cast<std::size_t>(std::ptrdiff_t{w} * h * c)) {}

  float* pixel(int x, int y) { return data.data() + (std::ptrdiff_t{y} * width + x) * channels; }
  const float* pixel(int x, int y) const { return data.data() + (std::ptrdiff_t{y} * width + x) * channels; }
};

/// 8-bit codes with 3 channels, in the pixel order of Image.
struct Image8 {
  int width = 0, height = 0;
  std::vector<unsigned char> rgb{};
  std::vector<unsigned char> alpha{};  ///< one code per pixel, empty if opaque; colours are not premultiplied
};

/// 16-bit codes with 3 channels, in the pixel order of Image.
struct Image16 {
  int width = 0, height = 0;
  std::vector<std::uint16_t> rgb{};
  std::vector<std::uint16_t> alpha{};  ///< like Image8::alpha
};

}  // namespace lippmann
