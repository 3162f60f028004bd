#include "transport/sky_patches.hpp"

#include <algorithm>
#include <cmath>

namespace lippmann {
namespace {

/// What find_sun() says in its declaration.
constexpr double kBright = 50.0, kLeastShare = 0.1, kMostSteradian = 0.02;

/// In [0, 1), of density proportional to a line from a to b >= 0; evenly where both are 0.
float sample_line(float u, float a, float b) {
  const float below_one = 0x1.fffffep-1f;
  if (!(a + b > 0.0f)) return u;
  // The ratio, as squares of what is bright overflow.
  const float most = std::max(a, b), from = a / most, to = b / most;
  const float root = std::sqrt(from * from + u * (to * to - from * from));
  return from + root > 0.0f ? std::min(u * (from + to) / (from + root), below_one) : 0.0f;
}

/// Bilinear, over its mean; 1 where all corners are 0.
float shape(const std::array<float, 4>& corners, Vec2f within) {
  const float mean = 0.25f * (corners[0] + corners[1] + corners[2] + corners[3]);
  const float upper = glm::mix(corners[0], corners[1], within.x), lower = glm::mix(corners[2], corners[3], within.x);
  return mean > 0.0f ? glm::mix(upper, lower, within.y) / mean : 1.0f;
}

struct Texel {
  int x, y;
  double luminance;
};

/// The patches that touch one of the texels.
PatchMask touched_patches(const SkyPatches& sky, const std::vector<Texel>& texels) {
  PatchMask touched(static_cast<std::size_t>(sky.width()) * static_cast<std::size_t>(sky.rows()), false);
  for (const Texel& t : texels)
    for (const int x : {t.x, t.x > 0 ? t.x - 1 : sky.width() - 1})
      for (const int y : {t.y, t.y + 1}) touched[sky.patch(x, y)] = true;
  return touched;
}

double solid_angle(const SkyPatches& sky, const PatchMask& patches) {
  double sum = 0.0;
  for (int y = 0; y < sky.rows(); ++y) {
    const auto first = patches.begin() + static_cast<std::ptrdiff_t>(sky.patch(0, y));
    sum += static_cast<double>(sky.patch_solid_angle(y)) * static_cast<double>(std::count(first, first + sky.width(), true));
  }
  return sum;
}

double light(const SkyPatches& sky, const std::vector<Texel>& texels) {
  double sum = 0.0;
  for (const Texel& t : texels) sum += t.luminance * static_cast<double>(sky.texel_solid_angle(t.y));
  return sum;
}

}  // namespace

SkyPatches::SkyPatches(int width, int height)
    : width_(width), height_(height), luminance_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
  const double step = M_PI / height;
  cosines_.push_back(1.0f);
  for (int y = 0; y < height; ++y) cosines_.push_back(static_cast<float>(std::cos(step * (y + 0.5))));
  cosines_.push_back(-1.0f);
}

float SkyPatches::texel_solid_angle(int y) const {
  const double step = M_PI / height_;
  return static_cast<float>((std::cos(step * y) - std::cos(step * (y + 1))) * 2.0 * M_PI / width_);
}

SkyPatches::Place SkyPatches::at(Vec2f across_down, float cosine) const {
  const float x = across_down.x * static_cast<float>(width_) - 0.5f, column = std::floor(x);
  Place place;
  place.x = column < 0.0f ? width_ - 1 : std::min(static_cast<int>(column), width_ - 1);
  place.y = std::min(static_cast<int>(across_down.y * static_cast<float>(height_) + 0.5f), height_);
  const float above = cosine_above(place.y), below = cosine_above(place.y + 1);
  place.within = {x - column, std::clamp((above - cosine) / (above - below), 0.0f, 1.0f)};
  return place;
}

std::array<float, 4> SkyPatches::corners(int x, int y) const {
  const int right = x + 1 < width_ ? x + 1 : 0, above = std::max(y - 1, 0), below = std::min(y, height_ - 1);
  return {luminance(x, above), luminance(right, above), luminance(x, below), luminance(right, below)};
}

PatchMask find_sun(const SkyPatches& sky) {
  double all = 0.0;
  for (int y = 0; y < sky.height(); ++y) {
    double row = 0.0;
    for (int x = 0; x < sky.width(); ++x) row += static_cast<double>(sky.luminance(x, y));
    all += row * static_cast<double>(sky.texel_solid_angle(y));
  }
  double level = kBright * all / (4.0 * M_PI);
  if (!(level > 0.0) || !std::isfinite(level)) return {};
  std::vector<Texel> bright;
  for (int y = 0; y < sky.height(); ++y)
    for (int x = 0; x < sky.width(); ++x)
      if (const auto of = static_cast<double>(sky.luminance(x, y)); of >= level) bright.push_back({x, y, of});
  while (light(sky, bright) >= kLeastShare * all) {
    PatchMask sun = touched_patches(sky, bright);
    if (solid_angle(sky, sun) <= kMostSteradian) return sun;
    level *= 2.0;
    std::erase_if(bright, [&](const Texel& t) { return t.luminance < level; });
  }
  return {};
}

PatchChoice::PatchChoice(const SkyPatches& sky, const std::function<bool(std::size_t patch)>& is_of) {
  std::vector<float> row_weights, weights(static_cast<std::size_t>(sky.width()));
  for (int y = 0; y < sky.rows(); ++y) {
    for (int x = 0; x < sky.width(); ++x) {
      const std::array<float, 4> c = is_of(sky.patch(x, y)) ? sky.corners(x, y) : std::array<float, 4>{};
      weights[static_cast<std::size_t>(x)] = 0.25f * (c[0] + c[1] + c[2] + c[3]);
    }
    columns_.emplace_back(weights);
    row_weights.push_back(static_cast<float>(columns_.back().total()) * sky.patch_solid_angle(y));
  }
  rows_ = DiscreteDistribution(row_weights);
}

float PatchChoice::density_of_patch(const SkyPatches& sky, int x, int y) const {
  const auto row = static_cast<std::size_t>(y);
  if (is_dark() || columns_[row].empty()) return 0.0f;
  return rows_.probability(row) * columns_[row].probability(static_cast<std::size_t>(x)) / sky.patch_solid_angle(y);
}

PatchChoice::Chosen PatchChoice::sample(const SkyPatches& sky, Vec2f u) const {
  Vec2f rest;
  const auto y = static_cast<int>(rows_.sample(u.y, rest.y));
  const auto x = static_cast<int>(columns_[static_cast<std::size_t>(y)].sample(u.x, rest.x));
  const std::array<float, 4> c = sky.corners(x, y);
  Vec2f within;
  within.y = sample_line(rest.y, c[0] + c[1], c[2] + c[3]);
  within.x = sample_line(rest.x, glm::mix(c[0], c[2], within.y), glm::mix(c[1], c[3], within.y));
  const float across = (static_cast<float>(x) + 0.5f + within.x) / static_cast<float>(sky.width());
  return {across, glm::mix(sky.cosine_above(y), sky.cosine_above(y + 1), within.y),
          density_of_patch(sky, x, y) * shape(c, within)};
}

float PatchChoice::density(const SkyPatches& sky, const SkyPatches::Place& place) const {
  const float of_patch = density_of_patch(sky, place.x, place.y);
  return of_patch > 0.0f ? of_patch * shape(sky.corners(place.x, place.y), place.within) : 0.0f;
}

}  // namespace lippmann
