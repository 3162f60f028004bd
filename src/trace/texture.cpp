#include "trace/texture.hpp"

#include <array>
#include <cstring>

#include "core/multiversion.hpp"
#include "trace/projection.hpp"

namespace lippmann {
namespace {

using Color = float __attribute__((vector_size(16)));  // R, G, B, A in one register
using Word = std::int32_t __attribute__((vector_size(16)));
using Code = std::uint16_t __attribute__((vector_size(16)));
using Pair = std::int64_t __attribute__((vector_size(16)));

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
  // Four codes interleaved with zeros are four 32-bit integers: two instructions on any x86-64.
  Pair packed{};
  std::memcpy(&packed, rgba, 8);
  const auto words = __builtin_shuffle(reinterpret_cast<Code>(packed), Code{}, Code{0, 8, 1, 9, 2, 10, 3, 11});
  return __builtin_convertvector(reinterpret_cast<Word>(words), Color) * kUnit;
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

/// One texture axis of one level. The wrap mode is folded into numbers, so that the same arithmetic, without branches and
/// vectorised, serves all of them.
struct Axis {
  float size, period, inverse_period, fold;
  int last, before, after;  ///< texel indices: the last one, the one left of 0, the one right of the last
};

LIPPMANN_INLINE Axis make_axis(int size, Wrap mode) {
  const bool repeat = mode == Wrap::kRepeat, mirror = mode == Wrap::kMirror;
  const float period = repeat ? 1.0f : mirror ? 2.0f : 0.0f;
  return {static_cast<float>(size),  period,   period > 0.0f ? 1.0f / period : 0.0f,
          mirror ? 2.0f : kInfinity, size - 1, repeat ? size - 1 : 0,
          repeat ? 0 : size - 1};
}

/// The two texels around coordinate t and the weight of the second.
struct Neighbours {
  int first, second;
  float blend;
};

LIPPMANN_INLINE Neighbours neighbours(float t, const Axis& axis) {
  const float in_period = t - axis.period * std::floor(t * axis.inverse_period);
  const float unfolded = std::min(in_period, axis.fold - in_period);
  const float x = std::min(std::max(unfolded, 0.0f), 1.0f) * axis.size - 0.5f;
  const int i = static_cast<int>(x + 1.0f) - 1;  // floor, for x >= -1
  return {i < 0 ? axis.before : i, i >= axis.last ? axis.after : i + 1, x - static_cast<float>(i)};
}

constexpr int kMaxProbes = 8;

/// `count` bilinear lookups along a line in one level: first all texel offsets and weights (vectorised), then the texels.
LIPPMANN_INLINE Color probe_line(const DeviceTexture& texture, std::size_t level_index, Vec2f uv, Vec2f line, int count) {
  const DeviceTexture::Level& level = texture.levels[level_index];
  const Axis axis_u = make_axis(level.width, texture.wrap_u), axis_v = make_axis(level.height, texture.wrap_v);
  const int width = level.width;
  const float inverse = 1.0f / static_cast<float>(count);
  std::int32_t offset[4][kMaxProbes];
  float weight[4][kMaxProbes];
  for (int k = 0; k < kMaxProbes; ++k) {
    const float along = (static_cast<float>(k) + 0.5f) * inverse - 0.5f;
    const Neighbours x = neighbours(uv.x + along * line.x, axis_u), y = neighbours(uv.y + along * line.y, axis_v);
    offset[0][k] = y.first * width + x.first, offset[1][k] = y.first * width + x.second;
    offset[2][k] = y.second * width + x.first, offset[3][k] = y.second * width + x.second;
    const float lower = y.blend * inverse, upper = inverse - lower;
    weight[0][k] = upper * (1.0f - x.blend), weight[1][k] = upper * x.blend;
    weight[2][k] = lower * (1.0f - x.blend), weight[3][k] = lower * x.blend;
  }
  const std::uint16_t* texels = level.rgba.data();
  Color sum{};
  for (int k = 0; k < count; ++k)
    for (int corner = 0; corner < 4; ++corner)
      sum += load(texels + 4 * static_cast<std::ptrdiff_t>(offset[corner][k])) * weight[corner][k];
  return sum;
}

LIPPMANN_INLINE Vec4f to_vec4(Color c) { return {c[0], c[1], c[2], c[3]}; }

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
  if (!(std::abs(uv.x) < 1e6f && std::abs(uv.y) < 1e6f)) uv = Vec2f(0.0f);  // no fraction left to look up
  const std::size_t last = texture.levels.size() - 1;
  const Vec2f size(texture.levels[0].width, texture.levels[0].height);
  float length_a = glm::length(footprint_a * size), length_b = glm::length(footprint_b * size);
  if (length_a < length_b) {
    std::swap(length_a, length_b);
    std::swap(footprint_a, footprint_b);
  }
  if (!(length_a < 1e6f && length_b < 1e6f)) return to_vec4(probe_line(texture, last, uv, Vec2f(0.0f), 1));  // the mean
  if (!(length_a > 1.0f)) return to_vec4(probe_line(texture, 0, uv, Vec2f(0.0f), 1));  // magnified, or no footprint
  const float shortest = std::max({length_b, 0.75f * length_a / kMaxProbes, 1.0f});
  // A probe's bilinear weights reach two texels: 4/3 of a texel apart they still cover the line without gaps.
  const int probes = std::clamp(static_cast<int>(std::ceil(0.75f * length_a / shortest - 1e-3f)), 1, kMaxProbes);
  float lod = std::min(std::log2(shortest), static_cast<float>(last));
  // Many overlapping probes hide the step from level to level by themselves; then one level does.
  if (probes >= 4) lod = std::floor(lod + 0.5f);
  const auto fine = static_cast<std::size_t>(lod);
  const float blend = lod - static_cast<float>(fine);
  Color sum = probe_line(texture, fine, uv, footprint_a, probes);
  if (blend > 0.0f) sum += (probe_line(texture, fine + 1, uv, footprint_a, probes) - sum) * blend;
  return to_vec4(sum);
}

Vec3f sample_projected(const DeviceTexture& texture, const ImageProjection& projection, Vec3f point, float path_length) {
  const auto [u, v, blur] = project(projection, point, path_length);
  const auto count = static_cast<int>(texture.levels.size());
  const float level = blur * (static_cast<float>(count) - 0.9999f);
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
