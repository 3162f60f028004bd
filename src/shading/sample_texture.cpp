#include <algorithm>
#include <cstring>

#include "device/fast_math.hpp"
#include "shading/projection.hpp"
#include "shading/texture.hpp"

namespace lippmann {
namespace {

using Color = float __attribute__((vector_size(16)));
using Word = std::int32_t __attribute__((vector_size(16)));
using Code = std::uint16_t __attribute__((vector_size(16)));
using Pair = std::int64_t __attribute__((vector_size(16)));

constexpr float kUnit = 1.0f / 65535.0f;
constexpr int kMaxProbes = 8;

struct alignas(64) LaneInts {
  std::int32_t lane[kLanes];
  LIPPMANN_INLINE std::int32_t& operator[](int i) { return lane[i]; }
  LIPPMANN_INLINE std::int32_t operator[](int i) const { return lane[i]; }
};

LIPPMANN_INLINE Color load(const std::uint16_t* texels, std::int32_t index) {
  // Interleaving four 16-bit codes with zeros gives four 32-bit integers, in two instructions.
  Pair packed{};
  std::memcpy(&packed, texels + 4 * static_cast<std::ptrdiff_t>(index), 8);
  const auto words = __builtin_shufflevector(reinterpret_cast<Code>(packed), Code{}, 0, 8, 1, 9, 2, 10, 3, 11);
  return __builtin_convertvector(reinterpret_cast<Word>(words), Color);
}

struct Neighbours {
  std::int32_t first, second;
  float blend;
};

struct Taps {
  LaneInts index[4];
  Lanes weight[4];

  LIPPMANN_INLINE void set(int i, int width, const Neighbours& x, const Neighbours& y, float share) {
    index[0][i] = y.first * width + x.first, index[1][i] = y.first * width + x.second;
    index[2][i] = y.second * width + x.first, index[3][i] = y.second * width + x.second;
    const float lower = y.blend * share, upper = share - lower;
    weight[0][i] = upper * (1.0f - x.blend), weight[1][i] = upper * x.blend;
    weight[2][i] = lower * (1.0f - x.blend), weight[3][i] = lower * x.blend;
  }
  /// Prefetches one texel of each row, because rows are far apart in memory.
  LIPPMANN_INLINE void prefetch(const std::uint16_t* texels, int i) const {
    __builtin_prefetch(texels + 4 * static_cast<std::ptrdiff_t>(index[0][i]));
    __builtin_prefetch(texels + 4 * static_cast<std::ptrdiff_t>(index[2][i]));
  }
  LIPPMANN_INLINE Color sum(const std::uint16_t* texels, int i) const {
    return (load(texels, index[0][i]) * weight[0][i] + load(texels, index[1][i]) * weight[1][i]) +
           (load(texels, index[2][i]) * weight[2][i] + load(texels, index[3][i]) * weight[3][i]);
  }
};

struct LevelPair {
  LaneInts fine, width[2], height[2];
  Lanes share[2];

  LIPPMANN_INLINE void look_up_sizes(const DeviceTexture& texture) {
    const auto last = static_cast<std::int32_t>(texture.levels.size()) - 1;
    for (int i = 0; i < kLanes; ++i)
      for (int l = 0; l < 2; ++l) {
        const DeviceTexture::Level& level = texture.levels[static_cast<std::size_t>(std::min(fine[i] + l, last))];
        width[l][i] = level.width, height[l][i] = level.height;
      }
  }
  LIPPMANN_INLINE const std::uint16_t* texels(const DeviceTexture& texture, int i, int l) const {
    return texture.levels[static_cast<std::size_t>(fine[i] + l)].rgba.data();
  }
};

/// For each lane, `count` sample points on a line. Their mean is the result of the lookup.
struct Probes {
  Lanes u, v, line_u, line_v, inverse_count;
  LaneInts count;
  LevelPair level;
};

LIPPMANN_INLINE int choose_probes(const DeviceTexture& texture, const UvLanes& uv, Probes& probes) {
  const auto width = static_cast<float>(texture.levels[0].width), height = static_cast<float>(texture.levels[0].height);
  const auto last = static_cast<float>(texture.levels.size() - 1);
  std::int32_t most = 1;
  LIPPMANN_FOR_LANES(i) {
    // Above 10^6, a float has hardly any fraction left.
    const bool known = (std::abs(uv.u[i]) < 1e6f) & (std::abs(uv.v[i]) < 1e6f);
    probes.u[i] = known ? uv.u[i] : 0.0f;
    probes.v[i] = known ? uv.v[i] : 0.0f;
    const float a_u = uv.a_u[i], a_v = uv.a_v[i], b_u = uv.b_u[i], b_v = uv.b_v[i];
    const float a_x = a_u * width, a_y = a_v * height, b_x = b_u * width, b_y = b_v * height;
    const float squared_a = a_x * a_x + a_y * a_y, squared_b = b_x * b_x + b_y * b_y;
    const bool along_b = squared_a < squared_b;
    const float longer = std::sqrt(std::max(squared_a, squared_b)), shorter = std::sqrt(std::min(squared_a, squared_b));
    const bool bounded = (squared_a < 1e12f) & (squared_b < 1e12f);  // other footprints get the mean of the texture
    const float shortest = std::max(std::max(shorter, 0.75f / kMaxProbes * longer), 1.0f);
    // The bilinear weights of a probe span two texels, so probes that are 4/3 of a texel apart leave no gaps.
    const float wanted = std::min(std::max(std::ceil(0.75f * longer / shortest - 1e-3f), 1.0f), static_cast<float>(kMaxProbes));
    const float count = bounded ? wanted : 1.0f;
    const float lod = std::min(fast_log2(bounded ? shortest : 1.0f), last);
    // Four or more overlapping probes hide the transition between two levels, so the nearest level is enough.
    const float smooth = count >= 4.0f ? std::floor(lod + 0.5f) : lod;
    const float chosen = bounded ? smooth : last;
    probes.line_u[i] = bounded ? (along_b ? b_u : a_u) : 0.0f;
    probes.line_v[i] = bounded ? (along_b ? b_v : a_v) : 0.0f;
    probes.inverse_count[i] = 1.0f / count;
    probes.count[i] = static_cast<std::int32_t>(count);
    most = std::max(most, static_cast<std::int32_t>(count));
    const auto fine = static_cast<std::int32_t>(chosen);
    probes.level.fine[i] = fine;
    probes.level.share[1][i] = chosen - static_cast<float>(fine);
    probes.level.share[0][i] = 1.0f - probes.level.share[1][i];
  }
  return most;
}

struct WrapNumbers {
  float period, inverse_period, fold;
  std::int32_t repeats;  ///< 1: the first texel follows the last one; 0: the last texel is repeated
};

LIPPMANN_INLINE WrapNumbers numbers_of(Wrap mode) {
  if (mode == Wrap::kRepeat) return {1.0f, 1.0f, kInfinity, 1};
  if (mode == Wrap::kMirror) return {2.0f, 0.5f, 2.0f, 0};
  return {0.0f, 0.0f, kInfinity, 0};
}

LIPPMANN_INLINE Neighbours neighbours(float t, std::int32_t size, const WrapNumbers& wrap) {
  const std::int32_t last = size - 1;
  const float in_period = t - wrap.period * std::floor(t * wrap.inverse_period);
  const float unfolded = std::min(in_period, wrap.fold - in_period);
  const float x = std::min(std::max(unfolded, 0.0f), 1.0f) * static_cast<float>(size) - 0.5f;
  const auto i = static_cast<std::int32_t>(x + 1.0f) - 1;
  const std::int32_t before = wrap.repeats * last, after = last - before;
  return {i < 0 ? before : i, i >= last ? after : i + 1, x - static_cast<float>(i)};
}

LIPPMANN_INLINE void place_probe(const Probes& probes, int k, int l, const WrapNumbers across, const WrapNumbers down,
                                 Taps& taps) {
  const float step = static_cast<float>(k) + 0.5f;
  LIPPMANN_FOR_LANES(i) {
    const float along = step * probes.inverse_count[i] - 0.5f;
    const Neighbours x = neighbours(probes.u[i] + along * probes.line_u[i], probes.level.width[l][i], across);
    const Neighbours y = neighbours(probes.v[i] + along * probes.line_v[i], probes.level.height[l][i], down);
    const float share = probes.level.share[l][i] * probes.inverse_count[i] * kUnit;
    taps.set(i, probes.level.width[l][i], x, y, share);
  }
}

}  // namespace

LIPPMANN_MULTIVERSION void sample_uv(const DeviceTexture& texture, const UvLanes& uv, const LaneMask& wanted,
                                     TexelLanes& texels) {
  Probes probes;
  const int most = choose_probes(texture, uv, probes);
  probes.level.look_up_sizes(texture);
  const WrapNumbers across = numbers_of(texture.wrap_u), down = numbers_of(texture.wrap_v);
  Taps taps[2][kMaxProbes];
  for (int k = 0; k < most; ++k)
    for (int l = 0; l < 2; ++l) place_probe(probes, k, l, across, down, taps[l][k]);
  const auto for_each_tap = [&](int i, const auto& fn) LIPPMANN_INLINE_LAMBDA {
    for (int l = 0; l < 2; ++l) {
      if (!(probes.level.share[l][i] > 0.0f)) continue;
      const std::uint16_t* of_level = probes.level.texels(texture, i, l);
      for (int k = 0; k < probes.count[i]; ++k) fn(taps[l][k], of_level);
    }
  };
  for (int i = 0; i < kLanes; ++i)
    if (wanted.lane[i])
      for_each_tap(i, [&](const Taps& of, const std::uint16_t* level) LIPPMANN_INLINE_LAMBDA { of.prefetch(level, i); });
  for (int i = 0; i < kLanes; ++i) {
    if (!wanted.lane[i]) continue;
    Color sum{};
    for_each_tap(i, [&](const Taps& of, const std::uint16_t* level) LIPPMANN_INLINE_LAMBDA { sum += of.sum(level, i); });
    texels.color.set(i, {sum[0], sum[1], sum[2]});
    texels.alpha[i] = sum[3];
  }
}

Vec4f sample_point(const DeviceTexture& texture, Vec2f uv, std::size_t of_level) {
  const bool known = (std::abs(uv.x) < 1e6f) & (std::abs(uv.y) < 1e6f);  // above 10^6, a float has hardly any fraction left
  const DeviceTexture::Level& level = texture.levels[of_level];
  const Neighbours x = neighbours(known ? uv.x : 0.0f, level.width, numbers_of(texture.wrap_u));
  const Neighbours y = neighbours(known ? uv.y : 0.0f, level.height, numbers_of(texture.wrap_v));
  const std::uint16_t* texels = level.rgba.data();
  const auto row = [&](std::int32_t of_y) {
    return load(texels, of_y * level.width + x.first) * (1.0f - x.blend) +
           load(texels, of_y * level.width + x.second) * x.blend;
  };
  const Color sum = (row(y.first) * (1.0f - y.blend) + row(y.second) * y.blend) * kUnit;
  return {sum[0], sum[1], sum[2], sum[3]};
}

namespace {

/// Blends the two nearest levels as Tachyon does. Between the last two levels, uses only the last one.
LIPPMANN_INLINE void choose_levels(const DeviceTexture& texture, const ProjectedLanes& at, LevelPair& level) {
  const auto count = static_cast<std::int32_t>(texture.levels.size());
  const float range = static_cast<float>(count) - 0.9999f;
  LIPPMANN_FOR_LANES(i) {
    const float chosen = at.blur[i] * range;
    const auto fine = static_cast<std::int32_t>(chosen);
    const bool last = fine >= count - 2;
    level.fine[i] = last ? count - 1 : fine;
    level.share[1][i] = last ? 0.0f : chosen - static_cast<float>(fine);
    level.share[0][i] = 1.0f - level.share[1][i];
  }
}

LIPPMANN_INLINE void place_projected(const ProjectedLanes& at, const LevelPair& level, int l, Taps& taps) {
  LIPPMANN_FOR_LANES(i) {
    const std::int32_t last_x = level.width[l][i] - 1, last_y = level.height[l][i] - 1;
    const float x = at.u[i] * static_cast<float>(last_x), y = at.v[i] * static_cast<float>(last_y);
    const auto x0 = static_cast<std::int32_t>(x), y0 = static_cast<std::int32_t>(y);
    const Neighbours columns{x0, std::min(x0 + 1, last_x), x - static_cast<float>(x0)};
    const Neighbours rows{y0, std::min(y0 + 1, last_y), y - static_cast<float>(y0)};
    taps.set(i, level.width[l][i], columns, rows, level.share[l][i] * kUnit);
  }
}

}  // namespace

LIPPMANN_MULTIVERSION void sample_projected(const DeviceTexture& texture, const ImageProjection& projection,
                                            const Lanes3& point, const Lanes& path_length, const LaneMask& wanted,
                                            Lanes3& color) {
  ProjectedLanes at;
  project(projection, point, path_length, wanted, at);
  LevelPair level;
  choose_levels(texture, at, level);
  level.look_up_sizes(texture);
  Taps taps[2];
  for (int l = 0; l < 2; ++l) place_projected(at, level, l, taps[l]);
  for (int i = 0; i < kLanes; ++i) {
    if (!wanted.lane[i]) continue;
    Color sum = taps[0].sum(level.texels(texture, i, 0), i);
    if (level.share[1][i] > 0.0f) sum += taps[1].sum(level.texels(texture, i, 1), i);
    color.set(i, {sum[0], sum[1], sum[2]});
  }
}

}  // namespace lippmann
