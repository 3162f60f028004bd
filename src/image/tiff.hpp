// Writes TIFF images of 8 or 16 bits with a print resolution. RGB images may have alpha (not premultiplied) and are tagged as
// sRGB or with a colour profile. CMYK images need a profile. Equal images give equal bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Largest number of pixels of a TIFF file. Files of other formats have a lower limit. Sides are at most 65,536 pixels.
inline constexpr std::int64_t kMaxTiffPixels = (std::int64_t{1} << 31) - 1;

enum class TiffKind {
  /// BigTIFF above about 3.5 GB of samples, because classic TIFF is limited to 4 GB.
  kAuto,
  kBig,
};

struct TiffOptions {
  double pixels_per_mm = 0.0;  ///< stored in pixels per inch; 0: not stored
  TiffKind kind = TiffKind::kAuto;
  std::span<const std::byte> profile = {};  ///< ICC profile of the codes; empty: sRGB
};

/// Cyan, magenta, yellow and black per pixel. The highest code is full ink.
template <class Code>
struct Inks {
  int width = 0, height = 0;
  std::vector<Code> cmyk;
};

void write_tiff(const std::filesystem::path& path, const Image8& image, const TiffOptions& options = {});
void write_tiff(const std::filesystem::path& path, const Image16& image, const TiffOptions& options = {});
/// options.profile must not be empty.
void write_tiff(const std::filesystem::path& path, const Inks<std::uint8_t>& image, const TiffOptions& options);
void write_tiff(const std::filesystem::path& path, const Inks<std::uint16_t>& image, const TiffOptions& options);

}  // namespace lippmann
