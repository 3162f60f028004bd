// Writes TIFF images of 8 or 16 bits with a print resolution: RGB with optional unassociated alpha, tagged as sRGB or with a
// colour profile, or CMYK with a profile. Equal images give equal bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Maximum number of pixels of prints, which may be larger than other files. Sides are at most 65,536 pixels.
inline constexpr std::int64_t kMaxTiffPixels = (std::int64_t{1} << 31) - 1;

enum class TiffKind {
  /// BigTIFF if a classic file might be too small, that is, for more than about 3.5 GB of samples.
  kAuto,
  kBig,
};

struct TiffOptions {
  double pixels_per_mm = 0.0;  ///< resolution, stored as dots per inch; 0: none
  TiffKind kind = TiffKind::kAuto;
  std::span<const std::byte> profile = {};  ///< ICC profile of the codes; empty: sRGB
};

/// CMYK codes: cyan, magenta, yellow and black, 4 samples per pixel; the highest code is full ink.
template <class Code>
struct Inks {
  int width = 0, height = 0;
  std::vector<Code> cmyk;
};

/// Write a deflate-compressed file atomically. Throw Error naming the file.
void write_tiff(const std::filesystem::path& path, const Image8& image, const TiffOptions& options = {});
void write_tiff(const std::filesystem::path& path, const Image16& image, const TiffOptions& options = {});
/// Write CMYK codes. options.profile must not be empty.
void write_tiff(const std::filesystem::path& path, const Inks<std::uint8_t>& image, const TiffOptions& options);
void write_tiff(const std::filesystem::path& path, const Inks<std::uint16_t>& image, const TiffOptions& options);

}  // namespace lippmann
