#include "transport/environment.hpp"

#include "core/multiversion.hpp"
#include "transport/bsdf.hpp"
#include "transport/fast_angles.hpp"

namespace lippmann {
namespace {

/// A gradient's grid: fine enough that it is followed, small enough for a cache.
constexpr int kGradientWidth = 64, kGradientHeight = 32;

/// x, y in [0, 1].
LIPPMANN_INLINE void find_place(float x, float y, float z, float rotation, float& across, float& down) {
  const float turns = 0.5f + (fast_atan2(z, x) - rotation) * (0.5f / kPi), fraction = turns - std::floor(turns);
  const float polar = fast_acos(std::min(std::max(y, -1.0f), 1.0f)) * (1.0f / kPi);
  const bool known = (fraction < 1.0f) & (polar <= 1.0f);  // not rounded up, nor of a direction that is not a number
  across = known ? fraction : 0.0f;
  down = known ? polar : 0.0f;
}

Vec2f place_of(Vec3f d, float rotation) {
  Vec2f place;
  find_place(d.x, d.y, d.z, rotation, place.x, place.y);
  return place;
}

/// A panorama's texels in tiles and how it is placed, as numbers for loops over directions.
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

/// Between a patch's corners; corner: where the red of the upper left one is; within, below: in [0, 1], across and down.
LIPPMANN_INLINE void interpolate(const float* texels, const SkyPatches::Layout& layout, int corner, float within, float below,
                                 float* light) {
  for (int c = 0; c < 3; ++c) {
    const int above = corner + c * layout.channel, under = above + layout.row;
    const float upper = texels[above] * (1.0f - within) + texels[above + 1] * within;
    const float lower = texels[under] * (1.0f - within) + texels[under + 1] * within;
    light[c] = upper * (1.0f - below) + lower * below;
  }
}

/// Bilinear.
LIPPMANN_INLINE void look_at(const Panorama map, float dx, float dy, float dz, float* light) {
  constexpr int kTile = SkyPatches::kTile;
  float across, down;
  find_place(dx, dy, dz, map.rotation, across, down);
  const float x = across * static_cast<float>(map.width) - 0.5f, y = down * static_cast<float>(map.height) + 0.5f;
  const float fx = std::floor(x), fy = std::min(std::floor(y), static_cast<float>(map.height));
  const int left = static_cast<int>(fx), row = static_cast<int>(fy), column = left < 0 ? map.width - 1 : left;
  const int tile = (row / kTile) * map.tiles_across + column / kTile;
  const int corner = map.layout.tile * tile + map.layout.row * (row % kTile) + column % kTile;
  interpolate(map.texels, map.layout, corner, x - fx, y - fy, light);
}

/// As look_at; a loop over several directions is made of wide instructions.
LIPPMANN_MULTIVERSION void look_at_all(const Panorama map, SkyRays& rays) {
#pragma GCC ivdep
  for (int i = 0; i < SkyRays::kRays; ++i) {
    float light[3];
    look_at(map, rays.x[i], rays.y[i], rays.z[i], light);
    rays.red[i] = light[0], rays.green[i] = light[1], rays.blue[i] = light[2];
  }
}

/// across: share of the turn; cosine: the polar angle's.
Vec3f direction_at(float across, float cosine, float rotation) {
  float sin_azimuth, cos_azimuth;
  fast_sin_cos((across - 0.5f) * 2.0f * kPi + rotation, sin_azimuth, cos_azimuth);
  const float sine = std::sqrt(std::max((1.0f - cosine) * (1.0f + cosine), 0.0f));
  return {sine * cos_azimuth, cosine, sine * sin_azimuth};
}

/// Light that is added up stays finite.
Vec3f bounded(Vec3f light) { return glm::min(light, Vec3f(1e30f)); }

Vec3f gradient(const Background& b, Vec3f d) {
  const float share = (glm::dot(d, b.up) - b.horizon_at) / (b.zenith_at - b.horizon_at);
  return glm::mix(b.horizon, b.zenith, std::clamp(share, 0.0f, 1.0f));
}

/// Columns go round, rows end at the poles.
Vec3f gradient_texel(const Background& b, int x, int y) {
  x = (x + kGradientWidth) % kGradientWidth, y = std::clamp(y, 0, kGradientHeight - 1);
  const float cosine = std::cos((static_cast<float>(y) + 0.5f) * (kPi / kGradientHeight));
  return gradient(b, direction_at((static_cast<float>(x) + 0.5f) / kGradientWidth, cosine, 0.0f));
}

/// Around a texel, as a gradient may begin between texels, and no light may have no chance.
Vec3f gradient_around(const Background& b, int x, int y) {
  Vec3f light(0.0f);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) light += gradient_texel(b, x + dx, y + dy) / 9.0f;
  return light;
}

SkyPatches patches_of(const Background& b) {
  if (!b.map) return {kGradientWidth, kGradientHeight, [&](int x, int y) { return gradient_around(b, x, y); }};
  return {b.map->radiance.width, b.map->radiance.height, [&](int x, int y) {
            const float* p = b.map->radiance.pixel(x, y);
            return bounded(b.map->strength * Vec3f(p[0], p[1], p[2]));
          }};
}

}  // namespace

Environment::Environment(const Background& background) : background_(background), patches_(patches_of(background)) {
  for (int y = 0; y < patches_.height(); ++y) {
    Vec3f row(0.0f);
    for (int x = 0; x < patches_.width(); ++x) row += background.map ? patches_.texel(x, y) : gradient_texel(background, x, y);
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
  if (!background_.map) return gradient(background_, direction);
  Vec3f light;
  look_at(Panorama(patches_, rotation()), direction.x, direction.y, direction.z, &light.x);
  return light;
}

void Environment::radiance(SkyRays& rays) const {
  if (background_.map) return look_at_all(Panorama(patches_, rotation()), rays);
  for (int i = 0; i < SkyRays::kRays; ++i) {
    const Vec3f light = gradient(background_, {rays.x[i], rays.y[i], rays.z[i]});
    rays.red[i] = light.x, rays.green[i] = light.y, rays.blue[i] = light.z;
  }
}

Environment::Sample Environment::sample(const PatchChoice& patches, Vec2f u) const {
  if (patches.is_dark()) return {};
  const PatchChoice::Chosen chosen = patches.sample(patches_, u);
  const SkyPatches::Place& place = chosen.place;
  Sample sample{direction_at(chosen.across, chosen.cosine, rotation()), chosen.density};
  if (!background_.map) {
    sample.radiance = gradient(background_, sample.direction);
    return sample;
  }
  const float down = fast_acos(chosen.cosine) * (1.0f / kPi) * static_cast<float>(patches_.height()) + 0.5f;
  const float below = std::clamp(down - static_cast<float>(place.y), 0.0f, 1.0f);
  interpolate(patches_.corner(place.x, place.y), patches_.layout(), 0, place.within.x, below, &sample.radiance.x);
  return sample;
}

Environment::Density Environment::density(Vec3f direction) const {
  const SkyPatches::Place place = patches_.at(place_of(direction, rotation()), direction.y);
  if (const float of_sun = sun_.density(patches_, place); of_sun > 0.0f) return {of_sun, true};
  return {rest_.density(patches_, place), false};
}

}  // namespace lippmann
