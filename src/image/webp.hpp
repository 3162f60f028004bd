// Writes 8-bit RGB images as WebP for web pages: lossless, with a third to half of the bytes of PNG, or lossy.
#pragma once

#include <cstddef>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Limit of the format.
inline constexpr int kMaxWebpSide = 16383;

/// Returns the bytes of a lossless file without alpha. effort: 0 (fast) ... 9 (small). Throws Error for sizes outside 1 ...
/// kMaxWebpSide.
std::vector<std::byte> encode_webp(const Image8& image, int effort);

/// Returns the bytes of a lossy file. quality: 0 (small) ... 100.
std::vector<std::byte> encode_lossy_webp(const Image8& image, int quality);

}  // namespace lippmann
