// Writes 8-bit RGB pictures as lossless WebP: half to a third of the bytes of PNG, for pages that are sent over a network.
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

}  // namespace lippmann
