// Reads and writes PPM files with codes of 8, 10, 12, 16 or any other number of bits, and PFM files with floats.
//
//   PPM  "P6\n<width> <height>\n<highest code>\n", then 3 codes per pixel, rows from the top. If the highest code is above 255,
//        each code has 2 bytes, the high byte first. PGM files (P5, grey) are read as three equal codes per pixel.
//   PFM  "Pf\n<width> <height>\n<scale>\n" for 1 channel, or "PF" for 3 channels, then floats, rows from the BOTTOM. Floats are
//        little-endian if scale < 0. Readers multiply values by |scale|. Files are written with scale -1.
// Readers of both formats check the header against the size of the file. All functions throw Error naming `where`.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann {

struct PpmCodes {
  Image16 codes;
  int highest = 255;  ///< highest possible code in the file's header, 1 ... 65535
};

PpmCodes parse_ppm(std::span<const std::byte> file, const std::string& where);
Image parse_pfm(std::span<const std::byte> file, const std::string& where);

PpmCodes read_ppm(const std::filesystem::path& path);
Image read_pfm(const std::filesystem::path& path);

/// PFM images must have 1 or 3 channels.
std::vector<std::byte> encode_ppm(const PpmCodes& picture);
std::vector<std::byte> encode_pfm(const Image& image);

void write_ppm(const std::filesystem::path& path, const PpmCodes& picture);
void write_pfm(const std::filesystem::path& path, const Image& image);

}  // namespace lippmann
