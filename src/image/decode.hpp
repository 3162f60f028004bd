// Decodes pictures of one format each, from a file's bytes in memory; read_image.hpp puts them together.
//
// A reader has three functions: whether the bytes begin as its format does; what the header says; the samples. Rows run from
// the top, channels are interleaved, colours come first and are not multiplied by alpha beyond what the file did. Nothing is
// printed: what a reader does not honour is in the header's notices. Memory is bounded by the limits (limits.hpp) and by what
// the file's bytes can hold. All but the recognising functions throw Error at `where` for what is truncated, damaged, too large
// or of no known kind. All functions may be called from several threads.
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

/// The side of the picture on which the first row and column of a file lie, 1 to 8 (TIFF 6.0, "Orientation"; EXIF uses the
/// same).
enum class Orientation { kUpright = 1, kMirrored, kUpsideDown, kFlipped, kTransposed, kRightSide, kTransversed, kLeftSide };

struct PictureHeader {
  int width = 0, height = 0;
  std::vector<std::string> channels;  ///< names: R G B A, Y, or those of an EXR file
  SampleKind kind = SampleKind::kByte;
  int colors = 0;  ///< how many of the first channels are the colour: 3, 1 (grey), 0 (none of an EXR file's channels is)
  Orientation orientation = Orientation::kUpright;  ///< of the samples, as the file has them
  std::vector<std::byte> profile = {};    ///< the ICC profile of the samples, unless it is sRGB's; decode_picture() applies it
  std::vector<std::string> notices = {};  ///< what of the file is not honoured: "its gamma of 1 is ...", to follow its name
};

using Samples = std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>>;

struct DecodedPicture {
  PictureHeader header;
  Samples samples;  ///< as the header's kind says; width x height x channels
};

/// Decodes whichever format the bytes begin as, turns the picture upright (orientation is kUpright) and applies its colour
/// profile: codes are sRGB's, `profile` is empty, and a notice names a profile that cannot be applied. An error that says what
/// the bytes are and lists the formats if they begin as none. The functions of single formats below leave samples as the file
/// has them.
PictureHeader picture_header(FileBytes file, const std::string& where);
DecodedPicture decode_picture(FileBytes file, const std::string& where);

bool is_png(FileBytes file);
PictureHeader png_header(FileBytes file, const std::string& where);
DecodedPicture decode_png(FileBytes file, const std::string& where);  ///< palettes as RGB, tRNS as alpha

bool is_jpeg(FileBytes file);
PictureHeader jpeg_header(FileBytes file, const std::string& where);
/// Grey or RGB; CMYK as sRGB, by its profile if it has one.
DecodedPicture decode_jpeg(FileBytes file, const std::string& where);

bool is_tiff(FileBytes file);
PictureHeader tiff_header(FileBytes file, const std::string& where);
/// The first picture: grey or RGB of 8 or 16 bits or floats, with further channels; CMYK with a profile as sRGB of 8 or 16
/// bits; all other kinds as 8-bit RGB.
DecodedPicture decode_tiff(FileBytes file, const std::string& where);

bool is_exr(FileBytes file);
PictureHeader exr_header(FileBytes file, const std::string& where);
/// The display window of the first part that has colours, in linear Rec. 709.
DecodedPicture decode_exr(FileBytes file, const std::string& where);

/// Light as it was measured: EXPOSURE and COLORCORR are undone, PRIMARIES and XYZE become linear Rec. 709. Rows and columns are
/// turned as the header says.
bool is_hdr(FileBytes file);
PictureHeader hdr_header(FileBytes file, const std::string& where);
DecodedPicture decode_hdr(FileBytes file, const std::string& where);

/// HEIC and AVIF; needs the module that heic_module.hpp describes.
bool is_heic(FileBytes file);
PictureHeader heic_header(FileBytes file, const std::string& where);
DecodedPicture decode_heic(FileBytes file, const std::string& where);

bool is_webp(FileBytes file);
PictureHeader webp_header(FileBytes file, const std::string& where);
DecodedPicture decode_webp(FileBytes file, const std::string& where);

bool is_netpbm(FileBytes file);
PictureHeader netpbm_header(FileBytes file, const std::string& where);
/// P5 and P6 of any highest code, scaled to 8 or 16 bits; PFM.
DecodedPicture decode_netpbm(FileBytes file, const std::string& where);

bool is_bmp(FileBytes file);
PictureHeader bmp_header(FileBytes file, const std::string& where);
DecodedPicture decode_bmp(FileBytes file, const std::string& where);

bool is_gif(FileBytes file);
PictureHeader gif_header(FileBytes file, const std::string& where);
/// The first picture of an animation: RGB, or RGBA where some of it may be transparent.
DecodedPicture decode_gif(FileBytes file, const std::string& where);

/// TGA has no mark of its own: whether the fields of a header fit together. To be asked last.
bool is_tga(FileBytes file);
PictureHeader tga_header(FileBytes file, const std::string& where);
DecodedPicture decode_tga(FileBytes file, const std::string& where);

/// "where: cannot be read as a picture: reason".
Error unreadable_picture(const std::string& where, const std::string& reason);

/// The header of a picture whose channels have the usual names.
PictureHeader plain_header(int width, int height, int channels, SampleKind kind);

/// Notes pixels that are not square: `aspect` times as wide as high.
void add_aspect_notice(PictureHeader& header, double aspect);

/// The usual names: Y; Y, A; R, G, B; R, G, B, A; then channel4, ...
std::vector<std::string> default_channels(int count);

}  // namespace lippmann
