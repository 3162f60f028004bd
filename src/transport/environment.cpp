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
      width_(background.map ? background.map->radiance.width : kGradientWidth),
      height_(background.map ? background.map->radiance.height : kGradientHeight) {
  const float step = kPi / static_cast<float>(height_);
  for (int y = 0; y <= height_; ++y) cosines_.push_back(std::cos(step * static_cast<float>(y)));
  for (std::size_t y = 0; y + 1 < cosines_.size(); ++y)
    solid_angles_.push_back((cosines_[y] - cosines_[y + 1]) * 2.0f * kPi / static_cast<float>(width_));
  std::vector<float> row_weights;
  const auto columns = static_cast<std::size_t>(width_);
  for (int y = 0; y < height_; ++y) {
    std::vector<float> weights(columns);
    for (int x = 0; x < width_; ++x) {
      // A texel's light reaches into its neighbours, where it is looked up bilinearly; no light may have no chance.
      Vec3f sum(0.0f);
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) sum += texel(x + dx, y + dy);
      weights[static_cast<std::size_t>(x)] = luminance(sum) / 9.0f;
      mean_radiance_ += texel(x, y) * (solid_angles_[static_cast<std::size_t>(y)] / (4.0f * kPi));
    }
    columns_.emplace_back(weights);
    row_weights.push_back(static_cast<float>(columns_.back().total()) * solid_angles_[static_cast<std::size_t>(y)]);
  }
  rows_ = DiscreteDistribution(row_weights);
}

/// Columns go round, rows end at the poles.
Vec3f Environment::texel(int x, int y) const {
  x = (x + width_) % width_, y = std::clamp(y, 0, height_ - 1);
  if (background_.map) {
    const float* p = background_.map->radiance.pixel(x, y);
    return background_.map->strength * Vec3f(p[0], p[1], p[2]);
  }
  const Vec2f place((static_cast<float>(x) + 0.5f) / static_cast<float>(width_),
                    (static_cast<float>(y) + 0.5f) / static_cast<float>(height_));
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

Environment::Sample Environment::sample(Vec2f u) const {
  Vec2f within;
  const std::size_t y = rows_.sample(u.y, within.y), x = columns_[y].sample(u.x, within.x);
  // Even in solid angle within the texel: in the cosine of the polar angle.
  const float cosine = glm::mix(cosines_[y], cosines_[y + 1], within.y);
  const Vec2f place((static_cast<float>(x) + within.x) / static_cast<float>(width_),
                    std::acos(std::clamp(cosine, -1.0f, 1.0f)) / kPi);
  const float chance = rows_.probability(y) * columns_[y].probability(x);
  return {direction_at(place, background_.map ? background_.map->rotation : 0.0f), chance / solid_angles_[y]};
}

float Environment::density(Vec3f direction) const {
  if (is_dark()) return 0.0f;
  const Vec2f place = place_of(direction, background_.map ? background_.map->rotation : 0.0f) * Vec2f(width_, height_);
  const auto x = std::min(static_cast<std::size_t>(place.x), static_cast<std::size_t>(width_ - 1));
  const auto y = std::min(static_cast<std::size_t>(place.y), static_cast<std::size_t>(height_ - 1));
  if (columns_[y].empty()) return 0.0f;
  return rows_.probability(y) * columns_[y].probability(x) / solid_angles_[y];
}

}  // namespace lippmann
