// Writes 8-bit RGB images as WebP for web pages. Lossless files are a third to half as large as PNG files. Lossy files are even
// smaller.
#pragma once

#include <cstddef>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Maximum width and height of a WebP image.
inline constexpr int kMaxWebpSide = 16383;

/// Returns the bytes of a lossless file without alpha. `effort` is 0 (fastest) to 9 (smallest file). Throws Error for sides
/// outside 1 to kMaxWebpSide.
std::vector<std::byte> encode_webp(const Image8& image, int effort);

/// Returns the bytes of a lossy file. `quality` is 0 (smallest file) to 100 (best).
std::vector<std::byte> encode_lossy_webp(const Image8& image, int quality);

}  // namespace lippmann
