// Writes PNG files: RGB images of 8 or 16 bits with optional alpha, tagged as sRGB or with a colour profile, and height maps as
// grey. Equal images give equal bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Strategies of zlib: kDefault searches for repeated bytes, kFiltered searches less, kRunLength finds only runs of equal
/// bytes, and kHuffman only applies Huffman coding.
enum class PngStrategy { kDefault, kFiltered, kRunLength, kHuffman };

/// Neighbours from which a byte is predicted; kAdaptive tries all filters for every row.
enum class PngFilter { kNone, kLeft, kUp, kAverage, kPaeth, kAdaptive };

/// docs/lab/decisions/0002-png-compression.md has the measurements behind the defaults.
struct PngOptions {
  /// Effort of deflate, from 0 (stored) to 9. kRunLength and kHuffman ignore it.
  int level = 1;
  PngStrategy strategy = PngStrategy::kDefault;
  PngFilter filter = PngFilter::kUp;
  double dots_per_inch = 0.0;               ///< stored in whole pixels per metre (pHYs); 0: not stored
  std::span<const std::byte> profile = {};  ///< ICC profile of RGB codes (iCCP); empty: sRGB
};

/// Row-major from the top left; 65535 is the greatest height.
struct HeightMap {
  int width = 0, height = 0;
  std::vector<std::uint16_t> codes = {};
};

/// Returns the bytes of the file. Throws Error for sides outside 1 ... 65536.
std::vector<std::byte> encode_png(const Image8& image, const PngOptions& options = {});

void write_png(const std::filesystem::path& path, const Image8& image, const PngOptions& options = {});
void write_png(const std::filesystem::path& path, const Image16& image, const PngOptions& options = {});
void write_png(const std::filesystem::path& path, const HeightMap& heights, const PngOptions& options = {});

}  // namespace lippmann
