// Decodes still WebP images with libwebp.
#include <webp/decode.h>

#include <cstring>
#include <string_view>

#include "image/color_profile.hpp"
#include "image/decode.hpp"
#include "image/exif.hpp"
#include "image/limits.hpp"

namespace lippmann {
namespace {

/// A lossless image of one colour takes about thirty bytes, so a file may have kFreePixels pixels regardless of its size.
/// Larger images may have kMaxPixelsPerByte pixels per byte.
constexpr std::uint64_t kFreePixels = std::uint64_t{1} << 22, kMaxPixelsPerByte = std::uint64_t{1} << 14;

const std::uint8_t* bytes_of(FileBytes file) { return reinterpret_cast<const std::uint8_t*>(file.data()); }

/// Returns the content of a chunk, or nothing if it is missing. A chunk is a name (4 bytes), a size (4 bytes, little-endian)
/// and data padded to an even size.
FileBytes webp_chunk(FileBytes file, std::string_view name) {
  constexpr std::size_t kFirst = 12, kChunkHeader = 8;
  for (std::size_t at = kFirst; at + kChunkHeader <= file.size();) {
    std::uint32_t size = 0;
    std::memcpy(&size, file.data() + at + 4, sizeof size);
    const std::size_t left = file.size() - at - kChunkHeader;
    if (size > left) return {};
    if (std::memcmp(file.data() + at, name.data(), name.size()) == 0) return file.subspan(at + kChunkHeader, size);
    at += kChunkHeader + size + size % 2;
  }
  return {};
}

}  // namespace

bool is_webp(FileBytes file) {
  return file.size() >= 12 && std::memcmp(file.data(), "RIFF", 4) == 0 && std::memcmp(file.data() + 8, "WEBP", 4) == 0;
}

PictureHeader webp_header(FileBytes file, const std::string& where) {
  WebPBitstreamFeatures features;
  const VP8StatusCode code = WebPGetFeatures(bytes_of(file), file.size(), &features);
  if (code == VP8_STATUS_NOT_ENOUGH_DATA) throw unreadable_picture(where, "the file is truncated");
  if (code != VP8_STATUS_OK) throw unreadable_picture(where, "its WebP header is damaged");
  if (features.has_animation) throw unreadable_picture(where, "it is an animated WebP file");
  const int channels = features.has_alpha ? 4 : 3;
  check_image_size(where, features.width, features.height, channels);
  const std::uint64_t pixels = static_cast<std::uint64_t>(features.width) * static_cast<std::uint64_t>(features.height);
  if (pixels > kFreePixels) check_file_holds(where, file.size(), pixels, kMaxPixelsPerByte);
  PictureHeader header = plain_header(features.width, features.height, channels, SampleKind::kByte);
  header.orientation = exif_orientation(webp_chunk(file, "EXIF"));
  header.profile = profile_to_apply(webp_chunk(file, "ICCP"));
  return header;
}

DecodedPicture decode_webp(FileBytes file, const std::string& where) {
  const PictureHeader header = webp_header(file, where);
  const std::size_t row = header.channels.size() * static_cast<std::size_t>(header.width);
  std::vector<std::uint8_t> codes(row * static_cast<std::size_t>(header.height));
  const auto decode = header.channels.size() == 4 ? WebPDecodeRGBAInto : WebPDecodeRGBInto;
  if (!decode(bytes_of(file), file.size(), codes.data(), codes.size(), static_cast<int>(row)))
    throw unreadable_picture(where, "its WebP data is truncated or damaged");
  return {header, std::move(codes)};
}

}  // namespace lippmann
