// Encodes small 8-bit pictures as PNG, JPEG or WebP files, for tests of the readers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lippmann::test {

/// Returns a PNG file. `channels` is 1 for grey, 2 for grey and alpha, 3 for RGB, or 4 for RGBA.
std::vector<unsigned char> encode_png(int width, int height, int channels, const std::vector<std::uint8_t>& samples);

/// Returns a JPEG file. `channels` is 1 for grey, 3 for RGB, or 4 for CMYK with inverted inks, as Adobe stores it.
std::vector<unsigned char> encode_jpeg(int width, int height, int channels, const std::vector<std::uint8_t>& samples,
                                       bool progressive = false);

/// Returns a lossless WebP file of RGBA samples.
std::vector<unsigned char> encode_webp(int width, int height, const std::vector<std::uint8_t>& samples);

}  // namespace lippmann::test
