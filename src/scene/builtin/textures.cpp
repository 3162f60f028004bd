// Gradient noise on a square lattice, after: Ken Perlin, "Improving Noise", SIGGRAPH 2002. We deviate: the noise is
// two-dimensional, and lattice coordinates are taken modulo the period so that textures repeat.
#include "scene/builtin/textures.hpp"

#include <algorithm>
#include <cmath>

#include "core/multiversion.hpp"
#include "core/random.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann::builtin {
namespace {

constexpr int kTexels = 512;

float fract(float x) { return x - std::floor(x); }

float ramp(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

LIPPMANN_INLINE int wrapped(int i, int period) { return i >= 0 && i < period ? i : ((i % period) + period) % period; }

struct LatticePlace {
  int before, after;  // indices of the lattice lines before and after the point, modulo the period
  float offset;
  float weight;
};

LIPPMANN_INLINE LatticePlace lattice_place(float p, int period) {
  const int line = static_cast<int>(std::floor(p)), before = wrapped(line, period);
  const float f = p - static_cast<float>(line);
  return {before, wrapped(before + 1, period), f, f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f)};
}

LIPPMANN_INLINE Vec2f lattice_gradient(int x, std::uint32_t row_hash) {
  constexpr float kDiagonal = 0.70710678f;
  static constexpr Vec2f kGradients[8] = {{1, 0},  {kDiagonal, kDiagonal},   {0, 1},  {-kDiagonal, kDiagonal},
                                          {-1, 0}, {-kDiagonal, -kDiagonal}, {0, -1}, {kDiagonal, -kDiagonal}};
  return kGradients[hash(static_cast<std::uint32_t>(x) ^ row_hash) >> 29];
}

template <class Above, class Below>
LIPPMANN_INLINE float noise_between(const LatticePlace& u, const LatticePlace& v, const Above& above, const Below& below) {
  const Vec2f f(u.offset, v.offset);
  const float a = glm::dot(above(u.before), f);
  const float b = glm::dot(above(u.after), f - Vec2f(1, 0));
  const float c = glm::dot(below(u.before), f - Vec2f(0, 1));
  const float d = glm::dot(below(u.after), f - Vec2f(1, 1));
  constexpr float kToUnitRange = 1.41421356f;
  return kToUnitRange * glm::mix(glm::mix(a, b, u.weight), glm::mix(c, d, u.weight), v.weight);
}

constexpr float kFractalScale = 1.3f;

/// Returns fractal_noise(period * uv, period, ...) for every texel of a square texture, rows from top to bottom.
std::vector<float> fractal_noise_of_texels(int period, int octaves, std::uint32_t seed) {
  const auto place_of = [&period](int texel) {
    return lattice_place(static_cast<float>(period) * ((static_cast<float>(texel) + 0.5f) / static_cast<float>(kTexels)),
                         period);
  };
  std::vector<float> sums(static_cast<std::size_t>(kTexels) * kTexels);
  float weight = 0.5f;
  for (int octave = 0; octave < octaves; ++octave, ++seed, period *= 2, weight *= 0.5f) {
    std::vector<LatticePlace> columns;
    for (int x = 0; x < kTexels; ++x) columns.push_back(place_of(x));
    std::vector<Vec2f> above(static_cast<std::size_t>(period)), below(above);
    float* sum = sums.data();
    for (int y = 0; y < kTexels; ++y) {
      const LatticePlace row = place_of(y);
      for (int x = 0; x < period; ++x) {
        above[static_cast<std::size_t>(x)] = lattice_gradient(x, hash(static_cast<std::uint32_t>(row.before), seed));
        below[static_cast<std::size_t>(x)] = lattice_gradient(x, hash(static_cast<std::uint32_t>(row.after), seed));
      }
      for (const LatticePlace& column : columns)
        *sum++ += weight * noise_between(
                               column, row, [&](int x) { return above[static_cast<std::size_t>(x)]; },
                               [&](int x) { return below[static_cast<std::size_t>(x)]; });
    }
  }
  for (float& sum : sums) sum *= kFractalScale;
  return sums;
}

float value_at(const std::vector<float>& values, Vec2f uv) {
  return values[static_cast<std::size_t>(uv.y * kTexels) * kTexels + static_cast<std::size_t>(uv.x * kTexels)];
}

/// Returns 1 within about half_width of a whole number, 0 elsewhere, with smooth edges.
float joint(float x, float half_width) {
  const float distance = std::abs(x - std::round(x));
  return 1.0f - ramp(0.5f * half_width, 1.5f * half_width, distance);
}

}  // namespace

Texture paint(std::string name, int width, int height, const std::function<Vec3f(Vec2f)>& color_at) {
  Image colors(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Vec3f color = color_at({(static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                                    (static_cast<float>(y) + 0.5f) / static_cast<float>(height)});
      std::copy_n(&color[0], 3, colors.pixel(x, y));
    }
  const Image8 codes = to_codes(colors, Encoding::kSrgb);
  Texture texture{std::move(name), width, height, {}};
  texture.rgba.assign(codes.rgb.size() / 3 * 4, 255);
  for (std::size_t i = 0; i < codes.rgb.size() / 3; ++i) std::copy_n(&codes.rgb[3 * i], 3, &texture.rgba[4 * i]);
  return texture;
}

LIPPMANN_MULTIVERSION float noise(Vec2f p, Vec2i period, std::uint32_t seed) {
  const LatticePlace u = lattice_place(p.x, period.x), v = lattice_place(p.y, period.y);
  const std::uint32_t above = hash(static_cast<std::uint32_t>(v.before), seed),
                      below = hash(static_cast<std::uint32_t>(v.after), seed);
  return noise_between(
      u, v, [above](int x) LIPPMANN_INLINE_LAMBDA { return lattice_gradient(x, above); },
      [below](int x) LIPPMANN_INLINE_LAMBDA { return lattice_gradient(x, below); });
}

float fractal_noise(Vec2f p, Vec2i period, int octaves, std::uint32_t seed) {
  float sum = 0.0f, weight = 0.5f;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += weight * noise(p, period, seed + static_cast<std::uint32_t>(octave));
    p *= 2.0f, period *= 2, weight *= 0.5f;
  }
  return kFractalScale * sum;
}

Texture marble_tiles(Vec3f light, Vec3f dark) {
  const std::vector<float> clouds = fractal_noise_of_texels(6, 4, 11), bends = fractal_noise_of_texels(6, 4, 23);
  return paint("marble tiles", kTexels, kTexels, [&](Vec2f uv) {
    const Vec2f tile = 2.0f * uv;
    const bool is_dark = (static_cast<int>(tile.x) + static_cast<int>(tile.y)) % 2 == 1;
    const float cloud = value_at(clouds, uv);
    const Vec2f bent = 4.0f * uv + 0.9f * Vec2f(cloud, value_at(bends, uv));
    const float vein = std::pow(1.0f - std::abs(noise(bent, {4, 4}, is_dark ? 31 : 37)), 12.0f);
    const Vec3f stone = is_dark ? dark * (1.0f + 0.5f * cloud) + 0.10f * vein : light * (1.0f + 0.10f * cloud) - 0.16f * vein;
    const float gap = std::max(joint(tile.x, 0.008f), joint(tile.y, 0.008f));
    return glm::mix(stone, 0.35f * (light + dark), gap);
  });
}

Texture wood_boards(Vec3f light, Vec3f dark, int boards) {
  return paint("wood boards", kTexels, kTexels, [=](Vec2f uv) {
    const float across = static_cast<float>(boards) * uv.x;
    const int board = static_cast<int>(across);
    const std::uint32_t seed = hash(71, static_cast<std::uint32_t>(board));
    const float bend = noise({3.0f * uv.x * static_cast<float>(boards), 4.0f * uv.y}, {3 * boards, 4}, seed);
    const float rings = 0.5f + 0.5f * std::sin(2.0f * kPi * (3.0f * fract(across) + 1.2f * bend));
    const float fibre = noise({40.0f * across, 6.0f * uv.y}, {40 * boards, 6}, seed + 5);
    const float tone = 0.35f * rings + 0.15f * fibre + 0.45f * unit_float(hash(seed));
    const float end_joint = joint(uv.y + unit_float(hash(seed + 9)), 0.004f);
    const float gap = std::max(joint(across, 0.025f), end_joint);
    return glm::mix(glm::mix(light, dark, tone), 0.25f * dark, gap);
  });
}

Texture striped_plaster(Vec3f color, Vec3f stripe, int stripes) {
  return paint("striped plaster", kTexels, kTexels, [=](Vec2f uv) {
    const float wave = std::abs(fract(static_cast<float>(stripes) * uv.x) - 0.5f);
    const float grain = fractal_noise(32.0f * uv, {32, 32}, 3, 41);
    return glm::mix(color, stripe, ramp(0.22f, 0.26f, wave)) * (1.0f + 0.05f * grain);
  });
}

Texture carpet(Vec3f ground, Vec3f ornament, Vec3f border) {
  return paint("carpet", kTexels, kTexels, [=](Vec2f uv) {
    const Vec2f edge = glm::min(uv, 1.0f - uv);
    const float inset = std::min(edge.x, edge.y);
    const Vec2f p = 6.0f * uv;
    const float rhombus = std::abs(fract(p.x) - 0.5f) + std::abs(fract(p.y) - 0.5f);
    Vec3f color = glm::mix(ornament, ground, ramp(0.30f, 0.34f, rhombus));
    color = glm::mix(color, border, 1.0f - ramp(0.10f, 0.17f, rhombus));
    if (inset < 0.11f) color = inset > 0.085f || inset < 0.02f ? ornament : border;
    return color * (1.0f + 0.2f * noise(96.0f * uv, {96, 96}, 53));
  });
}

Texture globe(Vec3f sea, Vec3f land) {
  return paint("globe", kTexels, kTexels / 2, [=](Vec2f uv) {
    const float height = fractal_noise({8.0f * uv.x, 4.0f * uv.y}, {8, 4}, 6, 7);
    const float latitude = std::abs(2.0f * uv.y - 1.0f);
    const Vec3f desert(0.55f, 0.40f, 0.20f), ice(0.85f, 0.88f, 0.90f);
    const Vec3f ground = glm::mix(glm::mix(land, desert, ramp(0.0f, 0.5f, noise({8.0f * uv.x, 6.0f * uv.y}, {8, 6}, 91))),
                                  0.5f * (land + desert), ramp(0.2f, 0.5f, height));
    Vec3f color = glm::mix(sea * (1.0f + 0.4f * height), ground, ramp(0.02f, 0.05f, height));
    color = glm::mix(color, ice, ramp(0.80f, 0.86f, latitude + 0.12f * height));
    const float meridian = std::max(joint(12.0f * uv.x, 0.012f), joint(6.0f * uv.y, 0.012f));
    return glm::mix(color, Vec3f(0.70f, 0.66f, 0.50f), 0.35f * meridian);
  });
}

}  // namespace lippmann::builtin
