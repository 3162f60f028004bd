// Writes 8-bit RGB pictures as WebP for pages that are sent over a network: lossless, with half to a third of the bytes of PNG,
// or lossy.
#pragma once

#include <cstddef>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// The format has no larger ones.
inline constexpr int kMostWebpSide = 16383;

/// The bytes of the file; alpha is left out. effort: 0 (fast) ... 9 (small). Throws Error for sizes outside 1 ...
/// kMostWebpSide.
std::vector<std::byte> encode_webp(const Image8& image, int effort);

/// The same with losses. quality: 0 (small) ... 100.
std::vector<std::byte> encode_lossy_webp(const Image8& image, int quality);

}  // namespace lippmann
