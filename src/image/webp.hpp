// Writes 8-bit RGB images as WebP for web pages. Lossless files are a third to half as large as PNG files.
#pragma once

#include <cstddef>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann {

inline constexpr int kMaxWebpSide = 16383;

/// Returns the bytes of a lossless file. `effort` is 0 (fastest) to 9 (smallest file). Throws Error for sides outside 1 to
/// kMaxWebpSide.
std::vector<std::byte> encode_webp(const Image8& image, int effort);

/// `quality` is 0 (smallest file) to 100 (best).
std::vector<std::byte> encode_lossy_webp(const Image8& image, int quality);

}  // namespace lippmann
