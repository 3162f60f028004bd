// Reads images: PNG, OpenEXR, TIFF, JPEG, Radiance HDR, WebP, HEIC, AVIF, BMP, GIF, PPM, PGM, PFM and TGA, recognised by their
// first bytes.
//
// Only the first image of a file is read. Limits are 65536 pixels a side and 2^28 pixels in total. Colours are not multiplied
// by alpha. Images are turned upright according to EXIF, TIFF, HDR and TGA metadata. Of an EXR file, the display window is read
// (exr_decode.cpp). EXR and HDR colours are converted to linear Rec. 709. HDR values are divided by the file's exposure. Codes
// are converted to sRGB by the ICC profile of the file (icc_transform.hpp). A warning names each ignored property that changes
// the picture, such as gamma, non-square pixels, or further parts and layers. All functions throw Error naming the file if it
// is missing, truncated, too large, or not an image.
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

/// Called with one complete sentence per warning. The sentence names the file. May be empty.
using PictureWarning = std::function<void(std::string_view)>;

/// Reads all channels in the file's order. For EXR files, R, G, B, A and Z come first. Integer samples are divided by their
/// maximum but not linearised; they are usually sRGB codes. Float samples do not change; they are usually linear.
Image read_image(const std::filesystem::path& path, const PictureWarning& warn = {});

/// Reads three channels: the colours, or grey repeated three times. Throws Error for an EXR file without colours.
Image read_rgb(const std::filesystem::path& path, const PictureWarning& warn = {});

/// Reads the named channels of an EXR file, in the order of `names` ("R", "Z", "N.X", ...). Throws Error listing the file's
/// channels if a name is unknown.
Image read_channels(const std::filesystem::path& path, std::span<const std::string> names);

/// A depth image that a file stores beside its main picture.
struct StoredDepth {
  Image grey;  ///< one channel, 0 to 1, of any size
  /// True: grey values grow with z, the distance from the camera. False: they grow with 1 / z or disparity.
  bool is_z = false;
};

/// Reads the depth image of a HEIC file, such as a phone's portrait photo. Returns nothing if the file has none, and for other
/// formats.
std::optional<StoredDepth> read_stored_depth(const std::filesystem::path& path);

/// Returns the names of the channels in the order of read_image().
std::vector<std::string> channel_names(const std::filesystem::path& path);

/// The channels that read_rgb() and read_image8() skip. For a file without colours, no channel is listed, because read_rgb()
/// and read_image8() throw.
struct LeftOutChannels {
  bool alpha = false;
  std::vector<std::string> others;
};
LeftOutChannels left_out_channels(const std::filesystem::path& path);

/// The type of a file's samples: 8-bit integers, 16-bit integers, or any other type. Other types are read as floats.
enum class SampleKind { kByte, kWord, kFloat };
SampleKind sample_kind(const std::filesystem::path& path);

/// Size and sample type of an image. Width and height are the size of the upright image.
struct PictureShape {
  int width = 0, height = 0;
  SampleKind kind = SampleKind::kByte;
};

/// Reads the shape of an image. For PNG and JPEG files, reads only the first bytes if they contain the whole header.
PictureShape picture_shape(const std::filesystem::path& path);

/// Reads 8-bit codes with 3 channels, like read_rgb(). 16-bit codes become round(255 code / 65535); floats are encoded as sRGB
/// (image/encode.hpp).
Image8 read_image8(const std::filesystem::path& path, const PictureWarning& warn = {});

/// Reads a file that this process has just written. Unlike read_image8(), does not check the file against the render's journal,
/// which does not name the file yet.
Image8 read_new_image8(const std::filesystem::path& path);

}  // namespace lippmann
