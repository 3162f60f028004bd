// Reads pictures: PNG, OpenEXR, TIFF, JPEG, Radiance HDR, WebP, BMP, GIF, PPM, PGM, PFM and TGA, told apart by their
// first bytes.
//
// Only the first picture of a file is read, at most 65536 pixels a side and 2^28 pixels in all; transparency is not applied.
// Pictures are turned upright as EXIF, TIFF, HDR and TGA files say. Of EXR files the display window is read (exr_decode.cpp).
// EXR and HDR colours become linear Rec. 709, HDR light what was measured. Codes become sRGB's by the ICC profile of the
// file (icc_transform.hpp). What a file says and is not honoured (gamma, pixels that are not square, further parts and layers)
// is warned about, if it does not come to the same. All throw Error naming the file if it is missing, truncated, not a picture,
// or too large.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Gets one complete sentence per call, which names the file; empty: nobody wants them.
using PictureWarning = std::function<void(std::string_view)>;

/// All channels, in the file's order (EXR: R, G, B, A, Z first). Integer samples become value / maximum, still encoded as the
/// file has them (sRGB, as a rule); float samples stay as they are (linear, as a rule).
Image read_image(const std::filesystem::path& path, const PictureWarning& warn = {});

/// The same, but three channels: the colours, or grey three times. Throws Error for an EXR file without colours.
Image read_rgb(const std::filesystem::path& path, const PictureWarning& warn = {});

/// The named channels of an EXR file, in this order ("R", "Z", "N.X", ...). An unknown name throws Error listing the file's.
Image read_channels(const std::filesystem::path& path, std::span<const std::string> names);

/// A depth image that a file stores beside its main picture.
struct StoredDepth {
  Image grey;         ///< one channel, 0 to 1, of any size
  bool is_z = false;  ///< grey grows with z, the distance from the camera; else with 1 / z or disparity
};

/// Reads the depth image of a HEIC file, such as a portrait photo of a telephone. Returns nothing for files without one and for
/// other formats.
std::optional<StoredDepth> read_stored_depth(const std::filesystem::path& path);

/// The channels' names in the order of read_image.
std::vector<std::string> channel_names(const std::filesystem::path& path);

/// The channels that read_rgb and read_image8 leave out; none of a file without colours, which they refuse.
struct LeftOutChannels {
  bool alpha = false;
  std::vector<std::string> others;
};
LeftOutChannels left_out_channels(const std::filesystem::path& path);

/// What a file's samples are: 8 bits, 16 bits, anything else.
enum class SampleKind { kByte, kWord, kFloat };
SampleKind sample_kind(const std::filesystem::path& path);

/// Size and samples of a picture; width and height are those of the upright picture.
struct PictureShape {
  int width = 0, height = 0;
  SampleKind kind = SampleKind::kByte;
};

/// Reads only the beginning of PNG and JPEG files where their headers fit into it.
PictureShape picture_shape(const std::filesystem::path& path);

/// The 8-bit codes: as stored; of 16-bit files round(255 code / 65535); of float files sRGB-encoded (image/encode.hpp).
/// Has 3 channels, as read_rgb() does.
Image8 read_image8(const std::filesystem::path& path, const PictureWarning& warn = {});

/// The same of a file that was written just now, which no journal has yet.
Image8 read_new_image8(const std::filesystem::path& path);

}  // namespace lippmann
