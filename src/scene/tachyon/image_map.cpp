#include "scene/tachyon/image_map.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "image/read_image.hpp"
#include "lippmann/core/error.hpp"
#include "scene/lexer.hpp"

namespace lippmann::tachyon {
namespace {

Image8 read_picture(const std::filesystem::path& file, const std::string& where) {
  try {
    return read_image8(file);
  } catch (const Error& error) {
    throw Error(where, fmt::format("the image map cannot be used: {}", error.what()));
  }
}

}  // namespace

Texture read_image_map(const std::filesystem::path& file, const std::string& where) {
  const std::string extension = upper(file.extension().string());
  const bool bottom_first = extension == ".TGA" || extension == ".PNG";
  if (!bottom_first && extension != ".PPM" && extension != ".JPG" && extension != ".JPEG")
    throw Error(where, fmt::format("{} has an unsupported image map format", shown(file.filename().string())),
                ".ppm, .tga, .jpg, .jpeg, .png");
  const Image8 picture = read_picture(file, where);
  Texture texture;
  texture.name = file.filename().string();
  texture.width = picture.width;
  texture.height = picture.height;
  texture.srgb = false;
  texture.rgba.reserve(picture.rgb.size() / 3 * 4);
  const std::size_t row = 3 * static_cast<std::size_t>(picture.width);
  for (int y = 0; y < picture.height; ++y) {
    const unsigned char* const source = &picture.rgb[row * static_cast<std::size_t>(bottom_first ? picture.height - 1 - y : y)];
    for (const unsigned char* p = source; p != source + row; p += 3)
      texture.rgba.insert(texture.rgba.end(), {p[0], p[1], p[2], std::uint8_t{255}});
  }
  return texture;
}

Texture white_image_map(std::string name) {
  Texture texture;
  texture.name = std::move(name);
  texture.width = texture.height = 4;
  texture.srgb = false;
  texture.rgba.assign(4 * 4 * 4, 255);
  return texture;
}

}  // namespace lippmann::tachyon
