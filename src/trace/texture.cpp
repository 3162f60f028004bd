#include "trace/texture.hpp"

#include <array>

namespace lippmann {
namespace {

const std::array<float, 256>& srgb_to_linear() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> t{};
    for (int i = 0; i < 256; ++i) {
      const double s = i / 255.0;
      t[static_cast<std::size_t>(i)] = static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
    }
    return t;
  }();
  return table;
}

std::uint8_t linear_to_srgb(float linear) {
  const double s = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(static_cast<double>(linear), 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::clamp(s * 255.0 + 0.5, 0.0, 255.0));
}

const std::uint8_t* texel(const DeviceTexture::Level& level, int x, int y) {
  return level.rgba.data() + 4 * (static_cast<std::size_t>(y) * level.width + x);
}

DeviceTexture::Level halve(const DeviceTexture::Level& fine, bool srgb, bool truncate) {
  DeviceTexture::Level coarse{std::max(1, fine.width / 2), std::max(1, fine.height / 2), {}};
  coarse.rgba.resize(4 * static_cast<std::size_t>(coarse.width) * coarse.height);
  const auto& decode = srgb_to_linear();
  for (int y = 0; y < coarse.height; ++y)
    for (int x = 0; x < coarse.width; ++x) {
      // Odd sizes: the last column or row of the coarse level also covers the one left over.
      const int x0 = x * fine.width / coarse.width, x1 = std::max(x0 + 1, (x + 1) * fine.width / coarse.width);
      const int y0 = y * fine.height / coarse.height, y1 = std::max(y0 + 1, (y + 1) * fine.height / coarse.height);
      const int count = (x1 - x0) * (y1 - y0);
      for (int c = 0; c < 4; ++c) {
        int bytes = 0;
        float linear = 0.0f;
        for (int fy = y0; fy < y1; ++fy)
          for (int fx = x0; fx < x1; ++fx) {
            const std::uint8_t value = texel(fine, fx, fy)[c];
            bytes += value;
            linear += decode[value];
          }
        std::uint8_t& out = coarse.rgba[4 * (static_cast<std::size_t>(y) * coarse.width + x) + static_cast<std::size_t>(c)];
        if (srgb && c < 3)
          out = linear_to_srgb(linear / static_cast<float>(count));
        else
          out = static_cast<std::uint8_t>(truncate ? bytes / count : (bytes + count / 2) / count);
      }
    }
  return coarse;
}

int wrap(int i, int size, Wrap mode) {
  switch (mode) {
    case Wrap::kClamp:
      return std::clamp(i, 0, size - 1);
    case Wrap::kMirror: {
      const int period = ((i % (2 * size)) + 2 * size) % (2 * size);
      return period < size ? period : 2 * size - 1 - period;
    }
    case Wrap::kRepeat:
      break;
  }
  return ((i % size) + size) % size;
}

Vec4f decode_texel(const std::uint8_t* rgba, bool srgb) {
  constexpr float kByte = 1.0f / 255.0f;
  if (!srgb) return Vec4f(rgba[0], rgba[1], rgba[2], rgba[3]) * kByte;
  const auto& table = srgb_to_linear();
  return {table[rgba[0]], table[rgba[1]], table[rgba[2]], static_cast<float>(rgba[3]) * kByte};
}

Vec4f bilinear(const DeviceTexture& texture, std::size_t level_index, Vec2f uv) {
  const DeviceTexture::Level& level = texture.levels[level_index];
  const float x = uv.x * static_cast<float>(level.width) - 0.5f, y = uv.y * static_cast<float>(level.height) - 0.5f;
  const float fx = std::floor(x), fy = std::floor(y);
  const int x0 = wrap(static_cast<int>(fx), level.width, texture.wrap_u);
  const int x1 = wrap(static_cast<int>(fx) + 1, level.width, texture.wrap_u);
  const int y0 = wrap(static_cast<int>(fy), level.height, texture.wrap_v);
  const int y1 = wrap(static_cast<int>(fy) + 1, level.height, texture.wrap_v);
  const Vec4f top =
      glm::mix(decode_texel(texel(level, x0, y0), texture.srgb), decode_texel(texel(level, x1, y0), texture.srgb), x - fx);
  const Vec4f bottom =
      glm::mix(decode_texel(texel(level, x0, y1), texture.srgb), decode_texel(texel(level, x1, y1), texture.srgb), x - fx);
  return glm::mix(top, bottom, y - fy);
}

Vec4f trilinear(const DeviceTexture& texture, Vec2f uv, float lod) {
  const float last = static_cast<float>(texture.levels.size() - 1);
  const float clamped = std::clamp(lod, 0.0f, last);
  const auto fine = static_cast<std::size_t>(clamped);
  const float blend = clamped - static_cast<float>(fine);
  const Vec4f a = bilinear(texture, fine, uv);
  if (blend == 0.0f) return a;
  return glm::mix(a, bilinear(texture, fine + 1, uv), blend);
}

// Tachyon interpolates over (resolution - 1) without wrapping.
Vec3f tachyon_bilinear(const DeviceTexture::Level& level, float u, float v) {
  const float x = u * static_cast<float>(level.width - 1), y = v * static_cast<float>(level.height - 1);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, level.width - 1), y1 = std::min(y0 + 1, level.height - 1);
  const float bx = x - static_cast<float>(x0), by = y - static_cast<float>(y0);
  const auto color = [&](int tx, int ty) {
    const std::uint8_t* t = texel(level, tx, ty);
    return Vec3f(t[0], t[1], t[2]) * (1.0f / 255.0f);
  };
  return glm::mix(glm::mix(color(x0, y0), color(x1, y0), bx), glm::mix(color(x0, y1), color(x1, y1), bx), by);
}

}  // namespace

DeviceTexture make_device_texture(const Texture& texture, bool tachyon) {
  DeviceTexture device;
  device.srgb = texture.srgb;
  device.wrap_u = texture.wrap_u;
  device.wrap_v = texture.wrap_v;
  device.levels.push_back({texture.width, texture.height, texture.rgba});
  while (device.levels.back().width > 1 || device.levels.back().height > 1)
    device.levels.push_back(halve(device.levels.back(), texture.srgb, tachyon));
  return device;
}

Vec4f sample_uv(const DeviceTexture& texture, Vec2f uv, Vec2f footprint_a, Vec2f footprint_b) {
  constexpr int kMaxProbes = 8;
  // The fraction alone decides, and keeps the texel index within int for any uv.
  if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return Vec4f(0.0f, 0.0f, 0.0f, 1.0f);
  if (texture.wrap_u != Wrap::kClamp) uv.x -= 2.0f * std::floor(0.5f * uv.x);
  if (texture.wrap_v != Wrap::kClamp) uv.y -= 2.0f * std::floor(0.5f * uv.y);
  uv = glm::clamp(uv, Vec2f(-4.0f), Vec2f(4.0f));
  const Vec2f size(texture.levels[0].width, texture.levels[0].height);
  float length_a = glm::length(footprint_a * size), length_b = glm::length(footprint_b * size);
  if (length_a < length_b) {
    std::swap(length_a, length_b);
    std::swap(footprint_a, footprint_b);
  }
  if (!(length_a > 1.0f)) return bilinear(texture, 0, uv);  // magnified, or no footprint
  const float shortest = std::max({length_b, length_a / kMaxProbes, 1.0f});
  const float lod = std::log2(shortest);
  const int probes = std::clamp(static_cast<int>(std::ceil(length_a / shortest - 1e-3f)), 1, kMaxProbes);
  Vec4f sum(0.0f);
  for (int i = 0; i < probes; ++i)
    sum += trilinear(texture, uv + footprint_a * ((static_cast<float>(i) + 0.5f) / static_cast<float>(probes) - 0.5f), lod);
  return sum / static_cast<float>(probes);
}

Vec3f sample_planar(const DeviceTexture& texture, const PlanarMapping& m, Vec3f point, float path_length) {
  const Vec3f q = point - m.center;
  float u = glm::dot(m.u_axis, q) * m.scale.x + m.rotate.x;
  float v = glm::dot(m.v_axis, q) * m.scale.y + m.rotate.y;
  u = std::fmod(u, 1.0f), v = std::fmod(v, 1.0f);
  if (u < 0.0f) u += 1.0f;
  if (v < 0.0f) v += 1.0f;
  const auto count = static_cast<int>(texture.levels.size());
  const float scale = std::max({std::abs(m.scale.x), std::abs(m.scale.y), std::abs(m.scale.z)});
  const float level = std::min(1.0f, 0.05f * path_length * scale) * (static_cast<float>(count) - 0.9999f);
  const int fine = static_cast<int>(level);
  if (fine >= count - 2) {
    const std::uint8_t* t = texture.levels.back().rgba.data();
    return Vec3f(t[0], t[1], t[2]) * (1.0f / 255.0f);
  }
  const Vec3f a = tachyon_bilinear(texture.levels[static_cast<std::size_t>(fine)], u, v);
  const Vec3f b = tachyon_bilinear(texture.levels[static_cast<std::size_t>(fine) + 1], u, v);
  return glm::mix(a, b, level - static_cast<float>(fine));
}

}  // namespace lippmann
