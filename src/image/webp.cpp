#include "image/webp.hpp"

#include <fmt/format.h>
#include <webp/encode.h>

#include <memory>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

Error unwritable_webp(const Image8& image, const std::string& reason) {
  return Error(fmt::format("a WebP picture of {}x{} pixels", image.width, image.height), reason,
               fmt::format("sides from 1 to {}", kMaxWebpSide));
}

int append_webp(const std::uint8_t* data, std::size_t size, const WebPPicture* picture) {
  auto& bytes = *static_cast<std::vector<std::byte>*>(picture->custom_ptr);
  const auto* first = reinterpret_cast<const std::byte*>(data);
  bytes.insert(bytes.end(), first, first + size);
  return 1;
}

void require_webp_size(const Image8& image) {
  if (image.width < 1 || image.height < 1 || image.width > kMaxWebpSide || image.height > kMaxWebpSide)
    throw unwritable_webp(image, "cannot be written");
}

std::vector<std::byte> encode_with(const WebPConfig& config, const Image8& image) {
  WebPPicture picture;
  if (!WebPPictureInit(&picture)) throw unwritable_webp(image, "cannot be written by this libwebp");
  const std::unique_ptr<WebPPicture, void (*)(WebPPicture*)> freed(&picture, WebPPictureFree);
  std::vector<std::byte> bytes;
  picture.use_argb = config.lossless, picture.width = image.width, picture.height = image.height;
  picture.writer = append_webp, picture.custom_ptr = &bytes;
  if (!WebPPictureImportRGB(&picture, image.rgb.data(), 3 * image.width) || !WebPEncode(&config, &picture))
    throw unwritable_webp(image, fmt::format("cannot be encoded: error {} of libwebp", static_cast<int>(picture.error_code)));
  return bytes;
}

}  // namespace

std::vector<std::byte> encode_webp(const Image8& image, int effort) {
  require_webp_size(image);
  WebPConfig config;
  if (!WebPConfigInit(&config) || !WebPConfigLosslessPreset(&config, effort))
    throw unwritable_webp(image, "cannot be written by this libwebp");
  config.exact = 1;
  return encode_with(config, image);
}

std::vector<std::byte> encode_lossy_webp(const Image8& image, int quality) {
  require_webp_size(image);
  WebPConfig config;
  if (!WebPConfigPreset(&config, WEBP_PRESET_PICTURE, static_cast<float>(quality)))
    throw unwritable_webp(image, "cannot be written by this libwebp");
  return encode_with(config, image);
}

}  // namespace lippmann
