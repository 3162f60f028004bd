// Reads images: PNG, OpenEXR, TIFF, JPEG, Radiance HDR, WebP, HEIC, AVIF, BMP, GIF, PPM, PGM, PFM and TGA, recognised by their
// first bytes.
//
// Only the first image of a file is read, with at most 65536 pixels a side and 2^28 pixels in total. Transparency is not
// applied. Images are turned upright according to EXIF, TIFF, HDR and TGA metadata. EXR files are read by display window
// (exr_decode.cpp). EXR and HDR colours are converted to linear Rec. 709, and HDR light to its measured scale. Codes are
// converted to sRGB by the ICC profile of the file (icc_transform.hpp). Ignored properties with an effect, such as gamma,
// non-square pixels, further parts and layers, give a warning. All functions throw Error naming the file if it is missing,
// truncated, too large, or not an image.
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

/// Receives one complete sentence per call, which names the file. May be empty.
using PictureWarning = std::function<void(std::string_view)>;

/// Reads all channels in the file's order (EXR: R, G, B, A, Z first). Integer samples become value / maximum in the file's
/// encoding, usually sRGB. Float samples do not change; they are usually linear.
Image read_image(const std::filesystem::path& path, const PictureWarning& warn = {});

/// Reads three channels: the colours, or grey three times. Throws Error for an EXR file without colours.
Image read_rgb(const std::filesystem::path& path, const PictureWarning& warn = {});

/// Reads the named channels of an EXR file, in this order ("R", "Z", "N.X", ...). Throws Error listing the file's channels if a
/// name is unknown.
Image read_channels(const std::filesystem::path& path, std::span<const std::string> names);

/// A depth image that a file stores beside its main picture.
struct StoredDepth {
  Image grey;         ///< one channel, 0 to 1, of any size
  bool is_z = false;  ///< grey grows with z, the distance from the camera; otherwise with 1 / z or disparity
};

/// Reads the depth image of a HEIC file, such as a portrait photo of a phone. Returns nothing for files without one and for
/// other formats.
std::optional<StoredDepth> read_stored_depth(const std::filesystem::path& path);

/// Returns the names of the channels in the order of read_image.
std::vector<std::string> channel_names(const std::filesystem::path& path);

/// The channels that read_rgb and read_image8 skip. Empty for a file without colours, for which they throw.
struct LeftOutChannels {
  bool alpha = false;
  std::vector<std::string> others;
};
LeftOutChannels left_out_channels(const std::filesystem::path& path);

/// The samples of a file: 8 bits, 16 bits, or anything else.
enum class SampleKind { kByte, kWord, kFloat };
SampleKind sample_kind(const std::filesystem::path& path);

/// Size and samples of an image. Width and height are those of the upright image.
struct PictureShape {
  int width = 0, height = 0;
  SampleKind kind = SampleKind::kByte;
};

/// Reads the shape of an image, from the first bytes of PNG and JPEG files if their header fits into them.
PictureShape picture_shape(const std::filesystem::path& path);

/// Reads 8-bit codes with 3 channels, as read_rgb(). 16-bit codes become round(255 code / 65535), floats are encoded as sRGB
/// (image/encode.hpp).
Image8 read_image8(const std::filesystem::path& path, const PictureWarning& warn = {});

/// Reads like read_image8() a file written just now that is not in a journal yet.
Image8 read_new_image8(const std::filesystem::path& path);

}  // namespace lippmann
