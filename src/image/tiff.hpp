// Writes 8-bit RGB pictures, with alpha (not associated) where they have it, as TIFF, tagged sRGB, with the resolution at which
// they are to be printed. Equal pictures give equal bytes.
#pragma once

#include <cstdint>
#include <filesystem>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Sides up to 65,536 pixels, and more of them than other files hold: prints.
inline constexpr std::int64_t kMaxTiffPixels = (std::int64_t{1} << 31) - 1;

enum class TiffKind {
  kAuto,  ///< BigTIFF where a classic file might not hold it: from 4 GB of samples on, less an eighth for what compresses badly
  kBig,
};

/// Deflate-compressed, in a file that appears only when complete.
/// pixels_per_mm: written as dots per inch; 0: the file says nothing. Throws Error naming the file.
void write_tiff(const std::filesystem::path& path, const Image8& image, double pixels_per_mm = 0.0,
                TiffKind kind = TiffKind::kAuto);

}  // namespace lippmann
