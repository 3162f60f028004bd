// Writes 8-bit RGB pictures as TIFF, tagged sRGB, with the resolution at which they are to be printed. Equal pictures give
// equal bytes.
#pragma once

#include <filesystem>

#include "image/image.hpp"

namespace lippmann {

/// Deflate-compressed, in a file that appears only when complete.
/// pixels_per_mm: written as dots per inch; 0: the file says nothing. Throws Error naming the file.
void write_tiff(const std::filesystem::path& path, const Image8& image, double pixels_per_mm = 0.0);

}  // namespace lippmann
