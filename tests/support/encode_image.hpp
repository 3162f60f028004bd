#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lippmann::test {

/// `channels`: 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA.
std::vector<unsigned char> encode_png(int width, int height, int channels, const std::vector<std::uint8_t>& samples);

/// `channels`: 1 grey, 3 RGB, 4 CMYK with inverted inks, as Adobe stores it.
std::vector<unsigned char> encode_jpeg(int width, int height, int channels, const std::vector<std::uint8_t>& samples,
                                       bool progressive = false);

std::vector<unsigned char> encode_webp(int width, int height, const std::vector<std::uint8_t>& samples);

}  // namespace lippmann::test
