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

/// A panorama and how it is placed, as numbers for loops over directions.
struct Panorama {
  explicit Panorama(const EnvironmentMap& map)
      : texels(map.radiance.data.data()),
        width(map.radiance.width),
        height(map.radiance.height),
        strength(map.strength),
        rotation(map.rotation) {}

  const float* texels;
  int width, height;
  float strength, rotation;
};

/// Bilinear. Columns go round, rows end at the poles.
LIPPMANN_INLINE void look_at(const Panorama map, float dx, float dy, float dz, float* light) {
  float across, down;
  find_place(dx, dy, dz, map.rotation, across, down);
  const float x = across * static_cast<float>(map.width) - 0.5f, y = down * static_cast<float>(map.height) - 0.5f;
  const float fx = std::floor(x), fy = std::floor(y), right = x - fx, below = y - fy;
  const int column = static_cast<int>(fx), row = static_cast<int>(fy);
  const int x0 = column < 0 ? map.width - 1 : column, x1 = column + 1 < map.width ? column + 1 : 0;
  const int y0 = std::max(row, 0) * map.width, y1 = std::min(row + 1, map.height - 1) * map.width;
  for (int c = 0; c < 3; ++c) {
    const float* of = map.texels + c;
    const float upper = of[3 * (y0 + x0)] * (1.0f - right) + of[3 * (y0 + x1)] * right;
    const float lower = of[3 * (y1 + x0)] * (1.0f - right) + of[3 * (y1 + x1)] * right;
    light[c] = map.strength * (upper * (1.0f - below) + lower * below);
  }
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

Vec3f direction_at(Vec2f place, float rotation) {
  const float azimuth = (place.x - 0.5f) * 2.0f * kPi + rotation, polar = place.y * kPi;
  const float sine = std::sin(polar);
  return {sine * std::cos(azimuth), std::cos(polar), sine * std::sin(azimuth)};
}

Vec3f gradient(const Background& b, Vec3f d) {
  const float share = (glm::dot(d, b.up) - b.horizon_at) / (b.zenith_at - b.horizon_at);
  return glm::mix(b.horizon, b.zenith, std::clamp(share, 0.0f, 1.0f));
}

}  // namespace

Environment::Environment(const Background& background)
    : background_(background),
      patches_(background.map ? background.map->radiance.width : kGradientWidth,
               background.map ? background.map->radiance.height : kGradientHeight) {
  for (int y = 0; y < patches_.height(); ++y)
    for (int x = 0; x < patches_.width(); ++x) {
      Vec3f light = texel(x, y);
      mean_radiance_ += light * (patches_.texel_solid_angle(y) / (4.0f * kPi));
      if (!background.map) {  // a gradient may begin between texels, and no light may have no chance
        light = Vec3f(0.0f);
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) light += texel(x + dx, y + dy) / 9.0f;
      }
      patches_.set(x, y, luminance(light));
    }
  const PatchMask sun = background.map ? find_sun(patches_) : PatchMask{};
  sun_ = PatchChoice(patches_, [&](std::size_t patch) { return !sun.empty() && sun[patch]; });
  rest_ = PatchChoice(patches_, [&](std::size_t patch) { return sun.empty() || !sun[patch]; });
}

float Environment::sun_share() const {
  const double all = sun_.total() + rest_.total();
  return all > 0.0 ? static_cast<float>(sun_.total() / all) : 0.0f;
}

/// Columns go round, rows end at the poles.
Vec3f Environment::texel(int x, int y) const {
  const int width = patches_.width(), height = patches_.height();
  x = (x + width) % width, y = std::clamp(y, 0, height - 1);
  if (background_.map) {
    const float* p = background_.map->radiance.pixel(x, y);
    return background_.map->strength * Vec3f(p[0], p[1], p[2]);
  }
  const Vec2f place((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                    (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
  return gradient(background_, direction_at(place, 0.0f));
}

Vec3f Environment::radiance(Vec3f direction) const {
  if (!background_.map) return gradient(background_, direction);
  Vec3f light;
  look_at(Panorama(*background_.map), direction.x, direction.y, direction.z, &light.x);
  return light;
}

void Environment::radiance(SkyRays& rays) const {
  if (background_.map) return look_at_all(Panorama(*background_.map), rays);
  for (int i = 0; i < SkyRays::kRays; ++i) {
    const Vec3f light = gradient(background_, {rays.x[i], rays.y[i], rays.z[i]});
    rays.red[i] = light.x, rays.green[i] = light.y, rays.blue[i] = light.z;
  }
}

Environment::Sample Environment::sample(const PatchChoice& patches, Vec2f u) const {
  if (patches.is_dark()) return {};
  const PatchChoice::Chosen chosen = patches.sample(patches_, u);
  const Vec2f place(chosen.across, std::acos(std::clamp(chosen.cosine, -1.0f, 1.0f)) / kPi);
  return {direction_at(place, rotation()), chosen.density};
}

Environment::Density Environment::density(Vec3f direction) const {
  const SkyPatches::Place place = patches_.at(place_of(direction, rotation()), direction.y);
  if (const float of_sun = sun_.density(patches_, place); of_sun > 0.0f) return {of_sun, true};
  return {rest_.density(patches_, place), false};
}

}  // namespace lippmann
