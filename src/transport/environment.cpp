#include "transport/environment.hpp"

#include "transport/bsdf.hpp"

namespace lippmann {
namespace {

/// A gradient's grid: fine enough that it is followed, small enough for a cache.
constexpr int kGradientWidth = 64, kGradientHeight = 32;

/// x, y in [0, 1).
Vec2f place_of(Vec3f d, float rotation) {
  const float x = 0.5f + (std::atan2(d.z, d.x) - rotation) * (0.5f / kPi), fraction = x - std::floor(x);
  if (!(fraction < 1.0f)) return Vec2f(0.0f);  // rounded up, or of a direction that is not a number
  return {fraction, std::acos(std::clamp(d.y, -1.0f, 1.0f)) * (1.0f / kPi)};
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
  const Vec2f at = place_of(direction, background_.map->rotation) * Vec2f(width_, height_) - Vec2f(0.5f);
  const float fx = std::floor(at.x), fy = std::floor(at.y);
  const int x = static_cast<int>(fx), y = static_cast<int>(fy);
  const auto row = [&](int of_y) { return glm::mix(texel(x, of_y), texel(x + 1, of_y), at.x - fx); };
  return glm::mix(row(y), row(y + 1), at.y - fy);
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
