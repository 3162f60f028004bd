#include "transport/environment.hpp"

#include "core/multiversion.hpp"
#include "transport/bsdf.hpp"
#include "transport/fast_angles.hpp"
#include "transport/light_range.hpp"

namespace lippmann {
namespace {

/// Size of the grid of texels that replaces a background gradient for sampling.
constexpr int kGradientWidth = 64, kGradientHeight = 32;

/// Computes the panorama coordinates of a direction, each in [0, 1]. `rotation` is in radians.
LIPPMANN_INLINE void find_place(float x, float y, float z, float rotation, float& across, float& down) {
  const float turns = 0.5f + (fast_atan2(z, x) - rotation) * (0.5f / kPi), fraction = turns - std::floor(turns);
  const float polar = fast_acos(std::min(std::max(y, -1.0f), 1.0f)) * (1.0f / kPi);
  const bool known = (fraction < 1.0f) & (polar <= 1.0f);  // rejects NaN directions, and values that were rounded up
  across = known ? fraction : 0.0f;
  down = known ? polar : 0.0f;
}

Vec2f place_of(Vec3f d, float rotation) {
  Vec2f place;
  find_place(d.x, d.y, d.z, rotation, place.x, place.y);
  return place;
}

/// A panorama's texels and its rotation in radians.
struct Panorama {
  Panorama(const SkyPatches& patches, float of_rotation)
      : texels(patches.texels_of(0)),
        width(patches.width()),
        height(patches.height()),
        tiles_across(patches.tiles_across()),
        layout(patches.layout()),
        rotation(of_rotation) {}

  const float* texels;
  int width, height, tiles_across;
  SkyPatches::Layout layout;
  float rotation;
};

/// Interpolates light at `within` (left to right) and `below` (top to bottom) of a patch, both in [0, 1]. `corner` is the
/// offset of the red value at the patch's upper left corner.
LIPPMANN_INLINE void interpolate(const float* texels, const SkyPatches::Layout& layout, int corner, float within, float below,
                                 float* light) {
  for (int c = 0; c < 3; ++c) {
    const int above = corner + c * layout.channel, under = above + layout.row;
    const float upper = texels[above] * (1.0f - within) + texels[above + 1] * within;
    const float lower = texels[under] * (1.0f - within) + texels[under + 1] * within;
    light[c] = upper * (1.0f - below) + lower * below;
  }
}

/// Looks up the panorama bilinearly at coordinates of find_place().
LIPPMANN_INLINE void look_at(const Panorama map, float across, float down, float* light) {
  constexpr int kTile = SkyPatches::kTile;
  const float x = across * static_cast<float>(map.width) - 0.5f, y = down * static_cast<float>(map.height) + 0.5f;
  const float fx = std::floor(x), fy = std::min(std::floor(y), static_cast<float>(map.height));
  const int left = static_cast<int>(fx), row = static_cast<int>(fy), column = left < 0 ? map.width - 1 : left;
  const int tile = (row / kTile) * map.tiles_across + column / kTile;
  const int corner = map.layout.tile * tile + map.layout.row * (row % kTile) + column % kTile;
  interpolate(map.texels, map.layout, corner, x - fx, y - fy, light);
}

LIPPMANN_MULTIVERSION void find_places(float rotation, SkyRays& rays) {
#pragma GCC ivdep
  for (int i = 0; i < SkyRays::kRays; ++i) find_place(rays.x[i], rays.y[i], rays.z[i], rotation, rays.across[i], rays.down[i]);
}

LIPPMANN_MULTIVERSION void look_at_all(const Panorama map, SkyRays& rays) {
#pragma GCC ivdep
  for (int i = 0; i < SkyRays::kRays; ++i) {
    float light[3];
    look_at(map, rays.across[i], rays.down[i], light);
    rays.red[i] = light[0], rays.green[i] = light[1], rays.blue[i] = light[2];
  }
}

LIPPMANN_INLINE void find_direction(float turn, float cosine, float rotation, float& x, float& y, float& z) {
  float sin_azimuth, cos_azimuth;
  fast_sin_cos((turn - 0.5f) * 2.0f * kPi + rotation, sin_azimuth, cos_azimuth);
  const float sine = std::sqrt(std::max((1.0f - cosine) * (1.0f + cosine), 0.0f));
  x = sine * cos_azimuth, y = cosine, z = sine * sin_azimuth;
}

/// Samples x in [0, 1) with a density that changes linearly from a at x = 0 to b at x = 1. If both are 0, the density is
/// uniform.
LIPPMANN_INLINE float sample_line(float u, float a, float b) {
  const float sum = a + b, from = a / (sum > 0.0f ? sum : 1.0f);
  const float root = std::sqrt(std::max(from * from + u * (1.0f - 2.0f * from), 0.0f)), both = from + root;
  const float within = both > 0.0f ? std::min(u / (both > 0.0f ? both : 1.0f), 0x1.fffffep-1f) : 0.0f;
  return sum > 0.0f ? within : u;
}

LIPPMANN_INLINE float mixed(float a, float b, float share) { return a * (1.0f - share) + b * share; }

/// The sampled patch of each lane, and random numbers for the position within the patch.
struct PatchDraws {
  alignas(64) float x[SkyDraws::kDraws], y[SkyDraws::kDraws];
  alignas(64) float u[SkyDraws::kDraws], v[SkyDraws::kDraws];
  alignas(64) float density[SkyDraws::kDraws];
  alignas(64) float upper[SkyDraws::kDraws], lower[SkyDraws::kDraws];
  /// Light at the corners, in the order of SkyPatches::corners; the second index is the channel.
  alignas(64) float corners[4][3][SkyDraws::kDraws];

  void set(int i, const SkyPatches& sky, const PatchChoice::Drawn& drawn) {
    x[i] = static_cast<float>(drawn.x), y[i] = static_cast<float>(drawn.y);
    u[i] = drawn.rest.x, v[i] = drawn.rest.y;
    density[i] = drawn.density_per_luminance;
    upper[i] = sky.cosine_above(drawn.y), lower[i] = sky.cosine_above(drawn.y + 1);
    const float* red = sky.corner(drawn.x, drawn.y);
    for (int c = 0; c < 3; ++c, red += sky.layout().channel)
      corners[0][c][i] = red[0], corners[1][c][i] = red[1], corners[2][c][i] = red[sky.layout().row],
      corners[3][c][i] = red[sky.layout().row + 1];
  }
  LIPPMANN_INLINE float luminance(int corner, int i) const {
    return 0.2126f * corners[corner][0][i] + 0.7152f * corners[corner][1][i] + 0.0722f * corners[corner][2][i];
  }
};

/// Samples a position within a patch in proportion to luminance, and computes the light there.
LIPPMANN_INLINE void draw_within(const Panorama& map, const PatchDraws& patches, int i, SkyDraws& draws) {
  const float upper_left = patches.luminance(0, i), upper_right = patches.luminance(1, i), lower_left = patches.luminance(2, i),
              lower_right = patches.luminance(3, i);
  const float down = sample_line(patches.v[i], upper_left + upper_right, lower_left + lower_right);
  const float left = mixed(upper_left, lower_left, down), right = mixed(upper_right, lower_right, down);
  const float across = sample_line(patches.u[i], left, right);
  draws.density[i] = patches.density[i] * mixed(left, right, across);
  const float turn = (patches.x[i] + 0.5f + across) / static_cast<float>(map.width);
  const float cosine = mixed(patches.upper[i], patches.lower[i], down);
  find_direction(turn, cosine, map.rotation, draws.x[i], draws.y[i], draws.z[i]);
  // Light is bilinear in the polar angle, but `down` is linear in the cosine of this angle.
  const float polar = fast_acos(std::min(std::max(cosine, -1.0f), 1.0f)) * (1.0f / kPi);
  const float below = std::min(std::max(polar * static_cast<float>(map.height) + 0.5f - patches.y[i], 0.0f), 1.0f);
  const auto channel = [&](int c) LIPPMANN_INLINE_LAMBDA {
    return mixed(mixed(patches.corners[0][c][i], patches.corners[1][c][i], across),
                 mixed(patches.corners[2][c][i], patches.corners[3][c][i], across), below);
  };
  draws.red[i] = channel(0), draws.green[i] = channel(1), draws.blue[i] = channel(2);
}

LIPPMANN_MULTIVERSION void draw_all_within(const Panorama map, const PatchDraws& patches, SkyDraws& draws) {
#pragma GCC ivdep
  for (int i = 0; i < SkyDraws::kDraws; ++i) draw_within(map, patches, i, draws);
}

Vec3f gradient(const Background& b, Vec3f d) {
  const float share = (glm::dot(d, b.up) - b.horizon_at) / (b.zenith_at - b.horizon_at);
  return glm::mix(b.horizon, b.zenith, std::clamp(share, 0.0f, 1.0f));
}

Vec3f gradient_texel(const Background& b, int x, int y) {
  x = (x + kGradientWidth) % kGradientWidth, y = std::clamp(y, 0, kGradientHeight - 1);
  const float cosine = std::cos((static_cast<float>(y) + 0.5f) * (kPi / kGradientHeight));
  Vec3f direction;
  find_direction((static_cast<float>(x) + 0.5f) / kGradientWidth, cosine, 0.0f, direction.x, direction.y, direction.z);
  return gradient(b, direction);
}

/// Returns the mean of a texel and its eight neighbours, so that all directions with light have a positive probability.
Vec3f gradient_around(const Background& b, int x, int y) {
  Vec3f light(0.0f);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) light += gradient_texel(b, x + dx, y + dy) / 9.0f;
  return light;
}

Background gradient_of(const Background& b) {
  return {in_light_range(b.horizon), in_light_range(b.zenith), b.up, b.horizon_at, b.zenith_at};
}

SkyPatches patches_of(const Background& b, const Background& sky) {
  if (!b.map)
    return {kGradientWidth, kGradientHeight, [&](int x, int y) { return in_light_range(gradient_around(sky, x, y)); }};
  return {b.map->radiance.width, b.map->radiance.height, [&](int x, int y) {
            const float* p = b.map->radiance.pixel(x, y);
            return in_light_range(b.map->strength * Vec3f(p[0], p[1], p[2]));
          }};
}

}  // namespace

Environment::Environment(const Background& background)
    : background_(background),
      gradient_(gradient_of(background)),
      rotation_(background.map ? std::remainder(background.map->rotation, 2.0f * kPi) : 0.0f),
      patches_(patches_of(background, gradient_)) {
  for (int y = 0; y < patches_.height(); ++y) {
    Vec3f row(0.0f);
    for (int x = 0; x < patches_.width(); ++x) row += background.map ? patches_.texel(x, y) : gradient_texel(gradient_, x, y);
    mean_radiance_ += row * (patches_.texel_solid_angle(y) / (4.0f * kPi));
  }
  const PatchMask sun = background.map ? find_sun(patches_) : PatchMask{};
  if (!sun.empty()) sun_ = PatchChoice(patches_, [&](std::size_t patch) { return sun[patch]; });
  rest_ = PatchChoice(patches_, [&](std::size_t patch) { return sun.empty() || !sun[patch]; });
}

float Environment::sun_share() const {
  const double all = sun_.total() + rest_.total();
  return all > 0.0 ? static_cast<float>(sun_.total() / all) : 0.0f;
}

Vec3f Environment::radiance(Vec3f direction) const {
  if (!background_.map) return gradient(gradient_, direction);
  const Vec2f place = place_of(direction, rotation_);
  Vec3f light;
  look_at(Panorama(patches_, rotation_), place.x, place.y, &light.x);
  return light;
}

void Environment::radiance(SkyRays& rays) const {
  find_places(rotation_, rays);
  if (background_.map) return look_at_all(Panorama(patches_, rotation_), rays);
  for (int i = 0; i < SkyRays::kRays; ++i) {
    const Vec3f light = gradient(gradient_, {rays.x[i], rays.y[i], rays.z[i]});
    rays.red[i] = light.x, rays.green[i] = light.y, rays.blue[i] = light.z;
  }
}

Environment::Sample Environment::sample(const PatchChoice& patches, Vec2f u) const {
  if (patches.is_dark()) return {};
  PatchDraws drawn;
  drawn.set(0, patches_, patches.draw_patch(patches_, patches.draw_row(patches_, u)));
  SkyDraws draws;
  draw_within(Panorama(patches_, rotation_), drawn, 0, draws);
  Sample sample{{draws.x[0], draws.y[0], draws.z[0]}, draws.density[0], {draws.red[0], draws.green[0], draws.blue[0]}};
  if (!background_.map) sample.radiance = gradient(gradient_, sample.direction);
  return sample;
}

void Environment::sample_rest(SkyDraws& draws) const {
  if (rest_.is_dark()) {
    std::fill_n(draws.density, SkyDraws::kDraws, 0.0f);
    return;
  }
  PatchChoice::Row rows[SkyDraws::kDraws];
  for (int i = 0; i < SkyDraws::kDraws; ++i) rows[i] = rest_.draw_row(patches_, {draws.u[i], draws.v[i]});
  PatchDraws patches;
  for (int i = 0; i < SkyDraws::kDraws; ++i) patches.set(i, patches_, rest_.draw_patch(patches_, rows[i]));
  draw_all_within(Panorama(patches_, rotation_), patches, draws);
  if (background_.map) return;
  for (int i = 0; i < SkyDraws::kDraws; ++i) {
    const Vec3f light = gradient(gradient_, {draws.x[i], draws.y[i], draws.z[i]});
    draws.red[i] = light.x, draws.green[i] = light.y, draws.blue[i] = light.z;
  }
}

Environment::Density Environment::density(const SkyRays& rays, int i) const {
  const SkyPatches::Place place = patches_.at({rays.across[i], rays.down[i]}, rays.y[i]);
  if (const float of_sun = sun_.density(patches_, place); of_sun > 0.0f) return {of_sun, true};
  return {rest_.density(patches_, place), false};
}

}  // namespace lippmann
