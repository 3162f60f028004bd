// Decodes images of each format from a file's bytes in memory. read_image.hpp has the interface for files.
//
// Each format has three functions. is_FORMAT() recognises the first bytes of a file, FORMAT_header() reads the header, and
// decode_FORMAT() decodes the samples. Samples are stored from the top row down, with interleaved channels, colours first.
// Colours are not multiplied by alpha. The header's `notices` list ignored data of the file. The limits in limits.hpp and the
// file's size bound the allocated memory. The header and decode functions throw Error at `where` if the file is truncated,
// damaged, too large or of an unsupported kind. All functions are thread-safe.
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

/// States on which sides of the upright picture the first stored row and the first stored column lie. The numbers are those of
/// the Orientation field of TIFF 6.0 and EXIF.
enum class Orientation { kUpright = 1, kMirrored, kUpsideDown, kFlipped, kTransposed, kRightSide, kTransversed, kLeftSide };

struct PictureHeader {
  int width = 0, height = 0;
  std::vector<std::string> channels;  ///< names of the channels: R, G, B, A, Y, or the names in an EXR file
  SampleKind kind = SampleKind::kByte;
  int colors = 0;  ///< number of colour channels: 3, 1 (grey), or 0 (an EXR file without colours); they come first
  Orientation orientation = Orientation::kUpright;  ///< orientation of the stored samples
  std::vector<std::byte> profile = {};  ///< ICC profile of the samples, or empty for sRGB; decode_picture() applies it
  /// Notes on ignored data of the file, such as "its gamma of 1 is ...". Warnings print them after the file name.
  std::vector<std::string> notices = {};
};

using Samples = std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>>;

struct DecodedPicture {
  PictureHeader header;
  Samples samples;  ///< width x height x channels samples of type header.kind
};

/// Read an image of any format, turn it upright and convert it from its colour profile to sRGB. Then header.orientation is
/// kUpright and header.profile is empty. If the profile cannot be applied, a notice names it. If the file has no supported
/// format, throw Error that lists all formats. The functions for single formats below return the samples as stored.
PictureHeader picture_header(FileBytes file, const std::string& where);
DecodedPicture decode_picture(FileBytes file, const std::string& where);

bool is_png(FileBytes file);
PictureHeader png_header(FileBytes file, const std::string& where);
DecodedPicture decode_png(FileBytes file, const std::string& where);  ///< palettes become RGB, tRNS becomes alpha

bool is_jpeg(FileBytes file);
PictureHeader jpeg_header(FileBytes file, const std::string& where);
/// Decodes grey or RGB. CMYK becomes sRGB, converted by the file's profile if there is one.
DecodedPicture decode_jpeg(FileBytes file, const std::string& where);

bool is_tiff(FileBytes file);
PictureHeader tiff_header(FileBytes file, const std::string& where);
/// Decodes the first image. Grey and RGB samples of 8 or 16 bits or floats are returned as stored, with all extra channels.
/// CMYK with a profile becomes sRGB of 8 or 16 bits. All other kinds become 8-bit RGB.
DecodedPicture decode_tiff(FileBytes file, const std::string& where);

bool is_exr(FileBytes file);
PictureHeader exr_header(FileBytes file, const std::string& where);
/// Decodes the display window of the first part that has colours, in linear Rec. 709.
DecodedPicture decode_exr(FileBytes file, const std::string& where);

/// Radiance HDR. decode_hdr() divides by EXPOSURE and COLORCORR, converts colours (PRIMARIES, XYZE) to linear Rec. 709, and
/// turns the image upright.
bool is_hdr(FileBytes file);
PictureHeader hdr_header(FileBytes file, const std::string& where);
DecodedPicture decode_hdr(FileBytes file, const std::string& where);

/// HEIC and AVIF. Decoding needs the module of heic_module.hpp.
bool is_heic(FileBytes file);
PictureHeader heic_header(FileBytes file, const std::string& where);
DecodedPicture decode_heic(FileBytes file, const std::string& where);
/// Decodes the depth image that is stored beside the main picture. Returns nothing if the file has no depth image.
std::optional<StoredDepth> decode_heic_depth(FileBytes file, const std::string& where);

bool is_webp(FileBytes file);
PictureHeader webp_header(FileBytes file, const std::string& where);
DecodedPicture decode_webp(FileBytes file, const std::string& where);

bool is_netpbm(FileBytes file);
PictureHeader netpbm_header(FileBytes file, const std::string& where);
/// Decodes PFM, PGM (P5) and PPM (P6) files. Codes of PGM and PPM files are scaled to the range of 8 or 16 bits.
DecodedPicture decode_netpbm(FileBytes file, const std::string& where);

bool is_bmp(FileBytes file);
PictureHeader bmp_header(FileBytes file, const std::string& where);
DecodedPicture decode_bmp(FileBytes file, const std::string& where);

bool is_gif(FileBytes file);
PictureHeader gif_header(FileBytes file, const std::string& where);
/// Decodes the first image of an animation as RGB, or as RGBA if it may have transparent pixels.
DecodedPicture decode_gif(FileBytes file, const std::string& where);

/// Returns whether the header fields are consistent. Check this format last, because TGA has no magic number.
bool is_tga(FileBytes file);
PictureHeader tga_header(FileBytes file, const std::string& where);
DecodedPicture decode_tga(FileBytes file, const std::string& where);

/// Returns the Error "where: cannot be read as a picture: reason".
Error unreadable_picture(const std::string& where, const std::string& reason);

/// Returns the header of an image whose channels have the default names.
PictureHeader plain_header(int width, int height, int channels, SampleKind kind);

/// Adds a notice if pixels are not square. `aspect` is width / height of a pixel.
void add_aspect_notice(PictureHeader& header, double aspect);

/// Returns the default names of 1 channel (Y), 2 (Y, A), 3 (R, G, B) or 4 channels (R, G, B, A). Further channels are named
/// channel4, channel5, ...
std::vector<std::string> default_channels(int count);

}  // namespace lippmann
