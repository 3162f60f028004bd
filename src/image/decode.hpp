// Decodes images of each format from a file's bytes in memory. read_image.hpp has the interface for files.
//
// is_FORMAT() recognises the first bytes of a file, FORMAT_header() reads its header, and decode_FORMAT() its samples, from the
// top row down with interleaved channels. Colours are not multiplied by alpha. The limits in limits.hpp and the file's size
// bound the allocated memory. Functions throw Error at `where` if the file is truncated, damaged, too large or of an
// unsupported kind. All are thread-safe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "image/read_image.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

using FileBytes = std::span<const std::byte>;

/// The sides of the upright picture on which the first stored row and column lie, numbered as in TIFF 6.0 and EXIF.
enum class Orientation { kUpright = 1, kMirrored, kUpsideDown, kFlipped, kTransposed, kRightSide, kTransversed, kLeftSide };

struct PictureHeader {
  int width = 0, height = 0;
  std::vector<std::string> channels;  ///< R, G, B, A, Y, or the names in an EXR file; colours come first
  SampleKind kind = SampleKind::kByte;
  int colors = 0;  ///< number of colour channels: 3, 1 (grey), or 0 (an EXR file without colours)
  Orientation orientation = Orientation::kUpright;
  std::vector<std::byte> profile = {};  ///< ICC profile of the samples, or empty for sRGB; decode_picture() applies it
  /// Notes for the user on ignored data, such as "its gamma of 1 is ...".
  std::vector<std::string> notices = {};
};

using Samples = std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>>;

struct DecodedPicture {
  PictureHeader header;
  Samples samples;
};

/// Read an image of any format, turn it upright and convert it to sRGB by its profile. The header's orientation is then
/// kUpright and its profile empty. Throw Error listing all formats if the format is unknown. The functions for single formats
/// below return the samples as stored.
PictureHeader picture_header(FileBytes file, const std::string& where);
DecodedPicture decode_picture(FileBytes file, const std::string& where);

bool is_png(FileBytes file);
PictureHeader png_header(FileBytes file, const std::string& where);
DecodedPicture decode_png(FileBytes file, const std::string& where);  ///< palettes become RGB, tRNS becomes alpha

bool is_jpeg(FileBytes file);
PictureHeader jpeg_header(FileBytes file, const std::string& where);
/// CMYK becomes sRGB, by the file's profile if there is one.
DecodedPicture decode_jpeg(FileBytes file, const std::string& where);

bool is_tiff(FileBytes file);
PictureHeader tiff_header(FileBytes file, const std::string& where);
/// Decodes the first image. Grey and RGB samples of 8 or 16 bits or floats are returned as stored, with extra channels. CMYK
/// with a profile becomes sRGB of 8 or 16 bits. All other kinds become 8-bit RGB.
DecodedPicture decode_tiff(FileBytes file, const std::string& where);

bool is_exr(FileBytes file);
PictureHeader exr_header(FileBytes file, const std::string& where);
/// Returns the display window of the first part with colours, in linear Rec. 709.
DecodedPicture decode_exr(FileBytes file, const std::string& where);

/// Radiance HDR. decode_hdr() applies the exposure, converts colours to linear Rec. 709, and turns the image upright.
bool is_hdr(FileBytes file);
PictureHeader hdr_header(FileBytes file, const std::string& where);
DecodedPicture decode_hdr(FileBytes file, const std::string& where);

bool is_heic(FileBytes file);
PictureHeader heic_header(FileBytes file, const std::string& where);
DecodedPicture decode_heic(FileBytes file, const std::string& where);
std::optional<StoredDepth> decode_heic_depth(FileBytes file, const std::string& where);

bool is_webp(FileBytes file);
PictureHeader webp_header(FileBytes file, const std::string& where);
DecodedPicture decode_webp(FileBytes file, const std::string& where);

bool is_netpbm(FileBytes file);
PictureHeader netpbm_header(FileBytes file, const std::string& where);
/// PFM, PGM (P5) and PPM (P6). Integer codes are scaled to 8 or 16 bits.
DecodedPicture decode_netpbm(FileBytes file, const std::string& where);

bool is_bmp(FileBytes file);
PictureHeader bmp_header(FileBytes file, const std::string& where);
DecodedPicture decode_bmp(FileBytes file, const std::string& where);

bool is_gif(FileBytes file);
PictureHeader gif_header(FileBytes file, const std::string& where);
DecodedPicture decode_gif(FileBytes file, const std::string& where);

/// Check this format last, because TGA has no magic number.
bool is_tga(FileBytes file);
PictureHeader tga_header(FileBytes file, const std::string& where);
DecodedPicture decode_tga(FileBytes file, const std::string& where);

/// The message is "where: cannot be read as a picture: reason".
Error unreadable_picture(const std::string& where, const std::string& reason);

PictureHeader plain_header(int width, int height, int channels, SampleKind kind);

/// Adds a notice if `aspect`, the width / height of a pixel, is not 1.
void add_aspect_notice(PictureHeader& header, double aspect);

/// Returns names for `count` channels: Y, (Y, A), (R, G, B) or (R, G, B, A), followed by channel4, channel5, ...
std::vector<std::string> default_channels(int count);

}  // namespace lippmann
