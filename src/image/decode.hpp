// Decodes pictures of one format each, from a file's bytes in memory; read_image.hpp puts them together.
//
// A reader has three functions: whether the bytes begin as its format does; what the header says; the samples. Rows run from
// the top, channels are interleaved, colours are not multiplied by alpha beyond what the file did, profiles and orientation
// tags are ignored. Nothing is printed. Memory is bounded by the limits (limits.hpp) and by what the file's bytes can hold.
// All but the recognising functions throw Error at `where` for what is truncated, damaged, too large or of no known kind.
// All functions may be called from several threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "image/read_image.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

using FileBytes = std::span<const std::byte>;

struct PictureHeader {
  int width = 0, height = 0;
  std::vector<std::string> channels;  ///< names: R G B A, Y, or those of an EXR file
  SampleKind kind = SampleKind::kByte;
};

using Samples = std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>>;

struct DecodedPicture {
  PictureHeader header;
  Samples samples;  ///< as the header's kind says; width x height x channels
};

/// Decodes whichever format the bytes begin as; an error that lists the formats if they begin as none.
PictureHeader picture_header(FileBytes file, const std::string& where);
DecodedPicture decode_picture(FileBytes file, const std::string& where);

bool is_png(FileBytes file);
PictureHeader png_header(FileBytes file, const std::string& where);
DecodedPicture decode_png(FileBytes file, const std::string& where);  ///< palettes as RGB, tRNS as alpha

bool is_jpeg(FileBytes file);
PictureHeader jpeg_header(FileBytes file, const std::string& where);
DecodedPicture decode_jpeg(FileBytes file, const std::string& where);  ///< grey or RGB; CMYK as RGB

bool is_tiff(FileBytes file);
PictureHeader tiff_header(FileBytes file, const std::string& where);
/// The first picture: grey or RGB of 8 or 16 bits or floats, with further channels; all other kinds as 8-bit RGB.
DecodedPicture decode_tiff(FileBytes file, const std::string& where);

bool is_exr(FileBytes file);
PictureHeader exr_header(FileBytes file, const std::string& where);
/// The first part's data window.
DecodedPicture decode_exr(FileBytes file, const std::string& where);

bool is_hdr(FileBytes file);
PictureHeader hdr_header(FileBytes file, const std::string& where);
DecodedPicture decode_hdr(FileBytes file, const std::string& where);

bool is_webp(FileBytes file);
PictureHeader webp_header(FileBytes file, const std::string& where);
DecodedPicture decode_webp(FileBytes file, const std::string& where);

bool is_netpbm(FileBytes file);
PictureHeader netpbm_header(FileBytes file, const std::string& where);
/// P5 and P6 of any highest code, scaled to 8 or 16 bits; PFM.
DecodedPicture decode_netpbm(FileBytes file, const std::string& where);

/// TGA has no mark of its own: whether the fields of a header fit together. To be asked last.
bool is_tga(FileBytes file);
PictureHeader tga_header(FileBytes file, const std::string& where);
DecodedPicture decode_tga(FileBytes file, const std::string& where);

/// "where: cannot be read as a picture: reason".
Error unreadable_picture(const std::string& where, const std::string& reason);

/// The usual names: Y; Y, A; R, G, B; R, G, B, A; then channel4, ...
std::vector<std::string> default_channels(int count);

}  // namespace lippmann
