// Writes pictures of 8 or 16 bits as TIFF, with the resolution at which they are to be printed: RGB, with alpha (not
// associated) where they have it, tagged sRGB or with a colour profile; or inks. Equal pictures give equal bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Sides up to 65,536 pixels, and more of them than other files hold: prints.
inline constexpr std::int64_t kMaxTiffPixels = (std::int64_t{1} << 31) - 1;

enum class TiffKind {
  kAuto,  ///< BigTIFF where a classic file might not hold it: from 4 GB of samples on, less an eighth for what compresses badly
  kBig,
};

struct TiffOptions {
  double pixels_per_mm = 0.0;  ///< written as dots per inch; 0: the file says nothing
  TiffKind kind = TiffKind::kAuto;
  std::span<const std::byte> profile = {};  ///< ICC profile of the codes; empty: they are sRGB's
};

/// Cyan, magenta, yellow, black, 4 samples a pixel; the highest code is full ink.
template <class Code>
struct Inks {
  int width = 0, height = 0;
  std::vector<Code> cmyk;
};

/// Deflate-compressed, in a file that appears only when complete. Throws Error naming the file.
void write_tiff(const std::filesystem::path& path, const Image8& image, const TiffOptions& options = {});
void write_tiff(const std::filesystem::path& path, const Image16& image, const TiffOptions& options = {});
/// options.profile is not empty.
void write_tiff(const std::filesystem::path& path, const Inks<std::uint8_t>& image, const TiffOptions& options);
void write_tiff(const std::filesystem::path& path, const Inks<std::uint16_t>& image, const TiffOptions& options);

}  // namespace lippmann
