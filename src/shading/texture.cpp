#include "shading/texture.hpp"

#include <array>

namespace lippmann {
namespace {

/// Returns a table from bytes to 16-bit linear codes. srgb: whether the bytes are sRGB-encoded.
std::array<std::uint16_t, 256> linear_codes(bool srgb) {
  std::array<std::uint16_t, 256> table{};
  for (std::size_t i = 0; i < 256; ++i) {
    const double s = static_cast<double>(i) / 255.0;
    const double linear = !srgb ? s : s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    table[i] = static_cast<std::uint16_t>(linear * 65535.0 + 0.5);
  }
  return table;
}

DeviceTexture::Level first_level(const Texture& texture) {
  const auto color = linear_codes(texture.srgb), alpha = linear_codes(false);
  DeviceTexture::Level level{texture.width, texture.height, {}};
  level.rgba.resize(texture.rgba.size());
  for (std::size_t i = 0; i < texture.rgba.size(); ++i) level.rgba[i] = (i % 4 == 3 ? alpha : color)[texture.rgba[i]];
  return level;
}

const std::uint16_t* texel(const DeviceTexture::Level& level, int x, int y) {
  return level.rgba.data() +
         4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) + static_cast<std::size_t>(x));
}

/// Halves the resolution. For odd sizes, the last column or row of the coarse level covers three texels. Tachyon mode ignores
/// the third texel, and rounds averages down to whole bytes. A byte b is stored as the code 257 * b.
DeviceTexture::Level halve(const DeviceTexture::Level& fine, bool tachyon) {
  DeviceTexture::Level coarse{std::max(1, fine.width / 2), std::max(1, fine.height / 2), {}};
  coarse.rgba.reserve(4 * static_cast<std::size_t>(coarse.width) * static_cast<std::size_t>(coarse.height));
  for (int y = 0; y < coarse.height; ++y)
    for (int x = 0; x < coarse.width; ++x) {
      const int x0 = 2 * x, x1 = x + 1 < coarse.width || tachyon ? std::min(x0 + 2, fine.width) : fine.width;
      const int y0 = 2 * y, y1 = y + 1 < coarse.height || tachyon ? std::min(y0 + 2, fine.height) : fine.height;
      const auto count = static_cast<std::uint32_t>((x1 - x0) * (y1 - y0));
      for (int c = 0; c < 4; ++c) {
        std::uint32_t sum = 0;
        for (int fy = y0; fy < y1; ++fy)
          for (int fx = x0; fx < x1; ++fx) sum += texel(fine, fx, fy)[c];
        coarse.rgba.push_back(static_cast<std::uint16_t>(tachyon ? sum / 257 / count * 257 : (sum + count / 2) / count));
      }
    }
  return coarse;
}

}  // namespace

DeviceTexture make_device_texture(const Texture& texture, bool tachyon) {
  DeviceTexture device;
  device.wrap_u = texture.wrap_u;
  device.wrap_v = texture.wrap_v;
  device.levels.push_back(first_level(texture));
  while (device.levels.back().width > 1 || device.levels.back().height > 1)
    device.levels.push_back(halve(device.levels.back(), tachyon));
  return device;
}

}  // namespace lippmann
