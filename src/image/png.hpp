// Writes 8-bit and 16-bit RGB pictures, with alpha where they have it, as PNG, tagged sRGB or with a colour profile, and
// heights as grey PNG without a colour space. Equal pictures give equal bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// What deflate looks for: repeats and statistics (default), fewer repeats (filtered), runs only, statistics only.
enum class PngStrategy { kDefault, kFiltered, kRunLength, kHuffman };

/// From which neighbours a byte is predicted; adaptive tries all for every row.
enum class PngFilter { kNone, kLeft, kUp, kAverage, kPaeth, kAdaptive };

/// The defaults are chosen by measurement: docs/lab/decisions/0002-png-compression.md.
struct PngOptions {
  int level = 1;  ///< deflate's effort, 0 (stored) ... 9; run-length and Huffman ignore it
  PngStrategy strategy = PngStrategy::kDefault;
  PngFilter filter = PngFilter::kUp;
  double dots_per_inch = 0.0;               ///< stated as whole pixels per metre (pHYs); 0: not stated
  std::span<const std::byte> profile = {};  ///< RGB profile of the codes (iCCP); empty: they are sRGB's
};

/// Heights, row-major from the top-left: 0 is the lowest, 65535 the highest.
struct HeightMap {
  int width = 0, height = 0;
  std::vector<std::uint16_t> codes = {};
};

/// The bytes of the file. Throws Error for sizes outside 1 ... 65536.
std::vector<std::byte> encode_png(const Image8& image, const PngOptions& options = {});

/// Puts them in a file that appears only when complete. Throws Error naming it.
void write_png(const std::filesystem::path& path, const Image8& image, const PngOptions& options = {});
void write_png(const std::filesystem::path& path, const Image16& image, const PngOptions& options = {});
void write_png(const std::filesystem::path& path, const HeightMap& heights, const PngOptions& options = {});

}  // namespace lippmann
