// Reads images: PNG, OpenEXR, TIFF, JPEG, Radiance HDR, WebP, HEIC, AVIF, BMP, GIF, PPM, PGM, PFM and TGA, recognised by their
// first bytes.
//
// Only the first image of a file is read, and turned upright. Limits are 65536 pixels a side and 2^28 pixels in total. Colours
// are not multiplied by alpha. EXR and HDR colours become linear Rec. 709; codes become sRGB by the file's ICC profile. A
// warning names each ignored property that changes the picture, such as gamma or non-square pixels. All functions throw Error
// naming the file if it is missing, truncated, too large, or not an image.
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

/// Called with one sentence per warning, which names the file. May be empty.
using PictureWarning = std::function<void(std::string_view)>;

/// Reads all channels in the file's order; in EXR files, R, G, B, A and Z come first. Integer samples are divided by their
/// maximum but not linearised; they are usually sRGB codes. Float samples are usually linear.
Image read_image(const std::filesystem::path& path, const PictureWarning& warn = {});

/// Reads the colours, or grey repeated three times. Throws Error for an EXR file without colours.
Image read_rgb(const std::filesystem::path& path, const PictureWarning& warn = {});

/// Reads the named channels of an EXR file ("R", "Z", "N.X", ...). Throws Error listing the file's channels if a name is
/// unknown.
Image read_channels(const std::filesystem::path& path, std::span<const std::string> names);

struct StoredDepth {
  Image grey;  ///< one channel, 0 to 1, of any size
  /// True: grey values grow with z, the distance from the camera. False: they grow with 1 / z or disparity.
  bool is_z = false;
};

std::optional<StoredDepth> read_stored_depth(const std::filesystem::path& path);

std::vector<std::string> channel_names(const std::filesystem::path& path);

/// Channels that read_rgb() and read_image8() skip.
struct LeftOutChannels {
  bool alpha = false;
  std::vector<std::string> others;
};
LeftOutChannels left_out_channels(const std::filesystem::path& path);

/// Reads the opacities of a picture (1 channel, 0 to 1). Returns nothing if the picture is opaque.
std::optional<Image> read_alpha(const std::filesystem::path& path);

/// kFloat stands for all other types, which are read as floats.
enum class SampleKind { kByte, kWord, kFloat };
SampleKind sample_kind(const std::filesystem::path& path);

struct PictureShape {
  int width = 0, height = 0;
  SampleKind kind = SampleKind::kByte;
};

/// Reads only the first bytes of PNG and JPEG files if they contain the header. The size is that of the upright image.
PictureShape picture_shape(const std::filesystem::path& path);

/// Reads 3 channels, like read_rgb(). 16-bit codes become round(255 code / 65535); floats are encoded as sRGB.
Image8 read_image8(const std::filesystem::path& path, const PictureWarning& warn = {});

/// Reads a file that this process has just written, and that the render's journal does not name yet.
Image8 read_new_image8(const std::filesystem::path& path);

}  // namespace lippmann
