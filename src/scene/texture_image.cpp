// Based on: Khronos Group, "glTF 2.0 Specification", 2021, section 3.8 "Texture Data": the first texel is the top left one, and
// readers ignore colour profiles and orientation tags. We apply this to all scene formats.
#include "scene/texture_image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/file_content.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann {
namespace {

/// Converts linear light, as in TIFF files with floats, to opaque sRGB codes.
DecodedPicture codes_of_light(DecodedPicture picture) {
  Image light;
  light.width = picture.header.width, light.height = picture.header.height;
  light.channels = static_cast<int>(picture.header.channels.size());
  light.data = std::get<std::vector<float>>(std::move(picture.samples));
  picture.header.channels = default_channels(3);
  picture.samples = to_codes(light, Encoding::kSrgb).rgb;
  return picture;
}

std::vector<std::uint8_t> to_bytes(Samples samples) {
  if (auto* bytes = std::get_if<std::vector<std::uint8_t>>(&samples)) return std::move(*bytes);
  const auto& words = std::get<std::vector<std::uint16_t>>(samples);
  std::vector<std::uint8_t> bytes(words.size());
  std::transform(words.begin(), words.end(), bytes.begin(),
                 [](std::uint32_t v) { return static_cast<std::uint8_t>((v * 255 + 32767) / 65535); });
  return bytes;
}

std::vector<std::uint8_t> expanded_to_rgba(std::vector<std::uint8_t> codes, std::size_t channels) {
  if (channels == 4) return codes;
  std::vector<std::uint8_t> rgba;
  rgba.reserve(codes.size() / channels * 4);
  for (const std::uint8_t* p = codes.data(); p != codes.data() + codes.size(); p += channels) {
    const bool grey = channels <= 2;
    rgba.insert(rgba.end(), {p[0], p[grey ? 0 : 1], p[grey ? 0 : 2], channels == 2 ? p[1] : std::uint8_t{255}});
  }
  return rgba;
}

struct Reader {
  bool (*recognises)(FileBytes);
  PictureHeader (*header)(FileBytes, const std::string&);
  DecodedPicture (*decode)(FileBytes, const std::string&);
};

/// TGA is last, because it has no magic number.
constexpr Reader kReaders[] = {{is_png, png_header, decode_png},    {is_jpeg, jpeg_header, decode_jpeg},
                               {is_webp, webp_header, decode_webp}, {is_bmp, bmp_header, decode_bmp},
                               {is_tiff, tiff_header, decode_tiff}, {is_gif, gif_header, decode_gif},
                               {is_tga, tga_header, decode_tga}};

const Reader* find_reader(FileBytes encoded) {
  for (const Reader& reader : kReaders)
    if (reader.recognises(encoded)) return &reader;
  return nullptr;
}

bool is_ktx2(FileBytes encoded) {
  constexpr std::string_view kIdentifier = "\xabKTX 20\xbb\r\n\x1a\n";
  return encoded.size() >= kIdentifier.size() && std::memcmp(encoded.data(), kIdentifier.data(), kIdentifier.size()) == 0;
}

const Reader& reader_of(FileBytes encoded, const std::string& where) {
  const Reader* reader = find_reader(encoded);
  if (!reader) throw Error(where, texture_image_problem(encoded));
  return *reader;
}

}  // namespace

std::string texture_image_problem(FileBytes encoded) {
  if (find_reader(encoded)) return {};
  if (is_ktx2(encoded)) return fmt::format("is a KTX2 file: {}", kKtx2Advice);
  const FileContent content = describe_content(encoded);
  const std::string advice = content.advice.empty() ? "PNG, JPEG, WebP, BMP, TIFF, GIF, TGA" : content.advice;
  return fmt::format("is {} (accepted: {})", content.what, advice);
}

Vec2i texture_size(FileBytes encoded, const std::string& where) {
  const PictureHeader header = reader_of(encoded, where).header(encoded, where);
  return {header.width, header.height};
}

void decode_texture(FileBytes encoded, const std::string& where, Texture& into) {
  DecodedPicture picture = reader_of(encoded, where).decode(encoded, where);
  if (std::holds_alternative<std::vector<float>>(picture.samples)) picture = codes_of_light(std::move(picture));
  into.width = picture.header.width, into.height = picture.header.height;
  into.rgba = expanded_to_rgba(to_bytes(std::move(picture.samples)), picture.header.channels.size());
}

}  // namespace lippmann
