// Writes 8-bit RGB images as WebP for web pages. Lossless files have a third to half of the bytes of PNG; lossy files are
// smaller.
#pragma once

#include <cstddef>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Maximum side of an image in the format.
inline constexpr int kMaxWebpSide = 16383;

/// Returns the bytes of a lossless file without alpha. effort: 0 (fast) ... 9 (small). Throws Error for sides outside 1 ...
/// kMaxWebpSide.
std::vector<std::byte> encode_webp(const Image8& image, int effort);

/// Returns the bytes of a lossy file. quality: 0 (small) ... 100.
std::vector<std::byte> encode_lossy_webp(const Image8& image, int quality);

}  // namespace lippmann
