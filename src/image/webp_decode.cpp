// WebP, by libwebp: still pictures.
#include <webp/decode.h>

#include <cstring>

#include "image/decode.hpp"
#include "image/limits.hpp"

namespace lippmann {
namespace {

/// A lossless picture of one colour has some thirty bytes, whatever its size; this is what small files may still be.
constexpr std::uint64_t kFreePixels = std::uint64_t{1} << 22, kMostPixelsPerByte = std::uint64_t{1} << 14;

const std::uint8_t* bytes_of(FileBytes file) { return reinterpret_cast<const std::uint8_t*>(file.data()); }

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
  if (pixels > kFreePixels) check_file_holds(where, file.size(), pixels, kMostPixelsPerByte);
  return {features.width, features.height, default_channels(channels), SampleKind::kByte};
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
