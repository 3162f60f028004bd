#include "trace/texture.hpp"

#include <array>
#include <cstring>

#include "core/multiversion.hpp"

namespace lippmann {
namespace {

using Color = float __attribute__((vector_size(16)));  // R, G, B, A in one register
using Word = std::int32_t __attribute__((vector_size(16)));
using Code = std::uint16_t __attribute__((vector_size(8)));

constexpr float kUnit = 1.0f / 65535.0f;

/// The 16-bit linear code of every sRGB byte.
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

LIPPMANN_INLINE const std::uint16_t* texel(const DeviceTexture::Level& level, int x, int y) {
  return level.rgba.data() +
         4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) + static_cast<std::size_t>(x));
}

LIPPMANN_INLINE Color load(const std::uint16_t* rgba) {
  Code code;
  std::memcpy(&code, rgba, sizeof(code));
  return __builtin_convertvector(__builtin_convertvector(code, Word), Color) * kUnit;
}

/// Half the size. Odd sizes: the last column or row of the coarse level also covers the one left over. Tachyon leaves that one
/// out, averages bytes and drops the remainder; a byte b is the code 257 b.
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

/// Brings a coordinate of the first tile into [0, 1], so that texels are found without dividing.
LIPPMANN_INLINE float folded(float t, Wrap mode) {
  if (mode == Wrap::kRepeat) return t - std::floor(t);
  if (mode == Wrap::kClamp) return std::clamp(t, 0.0f, 1.0f);
  const float in_period = t - 2.0f * std::floor(0.5f * t);
  return in_period > 1.0f ? 2.0f - in_period : in_period;
}

/// The texel beside the border of a folded coordinate, -1 <= i <= size.
LIPPMANN_INLINE int neighbour(int i, int size, Wrap mode) {
  if (i < 0) return mode == Wrap::kRepeat ? size - 1 : 0;
  if (i >= size) return mode == Wrap::kRepeat ? 0 : size - 1;
  return i;
}

LIPPMANN_INLINE Color bilinear(const DeviceTexture& texture, std::size_t level_index, Vec2f uv) {
  const DeviceTexture::Level& level = texture.levels[level_index];
  const float x = folded(uv.x, texture.wrap_u) * static_cast<float>(level.width) - 0.5f;
  const float y = folded(uv.y, texture.wrap_v) * static_cast<float>(level.height) - 0.5f;
  const int ix = static_cast<int>(x + 1.0f) - 1, iy = static_cast<int>(y + 1.0f) - 1;  // floor, for x >= -1
  const float fx = x - static_cast<float>(ix), fy = y - static_cast<float>(iy);
  const int x0 = neighbour(ix, level.width, texture.wrap_u), x1 = neighbour(ix + 1, level.width, texture.wrap_u);
  const int y0 = neighbour(iy, level.height, texture.wrap_v), y1 = neighbour(iy + 1, level.height, texture.wrap_v);
  const Color a = load(texel(level, x0, y0)), b = load(texel(level, x1, y0));
  const Color c = load(texel(level, x0, y1)), d = load(texel(level, x1, y1));
  const Color top = a + (b - a) * fx, bottom = c + (d - c) * fx;
  return top + (bottom - top) * fy;
}

LIPPMANN_INLINE Vec4f to_vec4(Color c) { return {c[0], c[1], c[2], c[3]}; }

LIPPMANN_INLINE Color trilinear(const DeviceTexture& texture, Vec2f uv, float lod) {
  const float clamped = std::clamp(lod, 0.0f, static_cast<float>(texture.levels.size() - 1));
  const auto fine = static_cast<std::size_t>(clamped);
  const float blend = clamped - static_cast<float>(fine);
  const Color a = bilinear(texture, fine, uv);
  if (blend == 0.0f) return a;
  return a + (bilinear(texture, fine + 1, uv) - a) * blend;
}

// Tachyon interpolates over (resolution - 1) without wrapping.
Vec3f tachyon_bilinear(const DeviceTexture::Level& level, float u, float v) {
  const float x = u * static_cast<float>(level.width - 1), y = v * static_cast<float>(level.height - 1);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, level.width - 1), y1 = std::min(y0 + 1, level.height - 1);
  const float bx = x - static_cast<float>(x0), by = y - static_cast<float>(y0);
  const auto color = [&](int tx, int ty) {
    const std::uint16_t* t = texel(level, tx, ty);
    return Vec3f(t[0], t[1], t[2]) * kUnit;
  };
  return glm::mix(glm::mix(color(x0, y0), color(x1, y0), bx), glm::mix(color(x0, y1), color(x1, y1), bx), by);
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

LIPPMANN_MULTIVERSION Vec4f sample_uv(const DeviceTexture& texture, Vec2f uv, Vec2f footprint_a, Vec2f footprint_b) {
  constexpr int kMaxProbes = 8;
  if (!(std::abs(uv.x) < 1e6f && std::abs(uv.y) < 1e6f)) uv = Vec2f(0.0f);  // no fraction left to look up
  const Vec2f size(texture.levels[0].width, texture.levels[0].height);
  float length_a = glm::length(footprint_a * size), length_b = glm::length(footprint_b * size);
  if (length_a < length_b) {
    std::swap(length_a, length_b);
    std::swap(footprint_a, footprint_b);
  }
  if (!(length_a < 1e6f && length_b < 1e6f)) return to_vec4(bilinear(texture, texture.levels.size() - 1, uv));  // the mean
  if (!(length_a > 1.0f)) return to_vec4(bilinear(texture, 0, uv));  // magnified, or no footprint
  const float shortest = std::max({length_b, length_a / kMaxProbes, 1.0f});
  float lod = std::log2(shortest);
  const int probes = std::clamp(static_cast<int>(std::ceil(length_a / shortest - 1e-3f)), 1, kMaxProbes);
  // Many overlapping probes hide the step from level to level by themselves; then one level each does.
  if (probes >= 4) lod = std::floor(lod + 0.5f);
  Color sum{};
  for (int i = 0; i < probes; ++i)
    sum += trilinear(texture, uv + footprint_a * ((static_cast<float>(i) + 0.5f) / static_cast<float>(probes) - 0.5f), lod);
  return to_vec4(sum * (1.0f / static_cast<float>(probes)));
}

Vec3f sample_planar(const DeviceTexture& texture, const PlanarMapping& m, Vec3f point, float path_length) {
  const Vec3f q = point - m.center;
  float u = glm::dot(m.u_axis, q) * m.scale.x + m.rotate.x;
  float v = glm::dot(m.v_axis, q) * m.scale.y + m.rotate.y;
  u = std::fmod(u, 1.0f), v = std::fmod(v, 1.0f);
  if (u < 0.0f) u += 1.0f;
  if (v < 0.0f) v += 1.0f;
  const auto count = static_cast<int>(texture.levels.size());
  const float scale = std::max(std::abs(m.scale.x), std::abs(m.scale.y));
  const float level = std::min(1.0f, 0.05f * path_length * scale) * (static_cast<float>(count) - 0.9999f);
  const int fine = static_cast<int>(level);
  if (fine >= count - 2) {
    const std::uint16_t* t = texture.levels.back().rgba.data();
    return Vec3f(t[0], t[1], t[2]) * kUnit;
  }
  const Vec3f a = tachyon_bilinear(texture.levels[static_cast<std::size_t>(fine)], u, v);
  const Vec3f b = tachyon_bilinear(texture.levels[static_cast<std::size_t>(fine) + 1], u, v);
  return glm::mix(a, b, level - static_cast<float>(fine));
}

}  // namespace lippmann
