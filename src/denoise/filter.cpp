#include "denoise/filter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lippmann {
namespace {

// What counts as the same surface, in standard deviations of a Gaussian.
constexpr float kNormalSpread = 0.15f;  ///< the length of the difference of unit normals
constexpr float kAlbedoSpread = 0.15f;
constexpr float kMetSpread = 0.2f;
constexpr float kPlaneSpread = 1.0f;  ///< distances between samples, off the plane of the surface
// What counts as the same light: in standard deviations of the difference of two guides.
constexpr float kLightSpread = 1.0f;
constexpr float kRelativeSpread = 0.02f;  ///< as a share of the light itself: differences that nobody sees
constexpr float kLeastWeight = 1e-4f;

constexpr int kViewReach = 3;

// What counts as a pixel that a single path has lit.
constexpr float kOneHalf = 0.4f;   ///< its noise over its light, at least: 0.4 where 70 % of it is in one half of its samples
constexpr float kBrighter = 2.0f;  ///< than its neighbours
constexpr float kSameMaterial = 4.0f;  ///< material_difference, at most
constexpr int kLeastNeighbours = 8;    ///< that are to know better

/// What is known of another pixel counts for less where its variance is more than so many times a pixel's own: else the edge of
/// a highlight, of which nothing is known, would be taken into all that lies around.
constexpr float kInfluence = 16.0f;

/// Light may differ from a pixel's own by so much of the variance that it is told to have, which is about twice of what it has
/// (NoisyFrame::noise); sums over 49 pixels are known to about a quarter.
constexpr float kExplained = 0.7f;

float square(float x) { return x * x; }
float squared_length(Vec3f v) { return glm::dot(v, v); }
float inverse_square(float x) { return 1.0f / (x * x); }

/// Sum of squares of how much two texels differ beside their light and place.
float material_difference(const Texel& a, const Texel& b) {
  return squared_length(a.normal - b.normal) * inverse_square(kNormalSpread) +
         squared_length(a.albedo - b.albedo) * inverse_square(kAlbedoSpread) +
         square(a.met - b.met) * inverse_square(kMetSpread);
}

float light_difference(Vec3f a, float variance_a, Vec3f b, float variance_b) {
  const float variance = variance_a + variance_b;
  const float visible = square(kRelativeSpread) * (squared_length(a) + squared_length(b)) + 1e-10f;
  return std::max(0.0f, squared_length(a - b) - variance) / (square(kLightSpread) * variance + visible);
}

/// How much another pixel counts by how well it is known.
float influence(float variance, float of_other) {
  constexpr float kNoNoise = 1e-10f;
  return std::min(1.0f, kInfluence * (variance + kNoNoise) / (of_other + kNoNoise));
}

float weight_of(float difference) { return difference < 18.0f ? std::exp(-0.5f * difference) : 0.0f; }

/// A mean under way.
struct Mean {
  Vec3f light{0.0f};
  float variance = 0.0f, weight = 0.0f;

  void add(Vec3f value, float its_variance, float w) {
    light += w * value;
    variance += w * w * its_variance;
    weight += w;
  }
  Estimate finished() const { return {light / weight, variance / (weight * weight)}; }
};

/// fn(view, x, y, index) for every pixel; rows in parallel.
template <class Fn>
void for_each_pixel(const ViewGeometry& views, const ThreadPool& pool, const Fn& fn) {
  const Vec2i size = views.view_size();
  pool.for_each(static_cast<std::size_t>(views.views()) * static_cast<std::size_t>(size.y), [&](std::size_t row) {
    const int view = static_cast<int>(row) / size.y, y = static_cast<int>(row) % size.y;
    for (int x = 0; x < size.x; ++x) fn(view, x, y, row * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x));
  });
}

/// How far b's point lies off the plane of a's surface, in samples, squared and over the spread.
class PlaneOf {
 public:
  PlaneOf(const ViewGeometry& views, const Texel& a, Vec2f pixel, int view, float samples)
      : views_(views), point_(views.point(pixel, a.z, view)) {
    const float length = glm::length(a.normal);
    normal_ = length > 0.0f ? a.normal / length : Vec3f(0.0f);
    scale_ = inverse_square(kPlaneSpread * samples * views.sample_distance_mm(a.z) + 1e-6f);
  }
  float difference(const Texel& b, Vec2f pixel, int view) const {
    return square(glm::dot(normal_, views_.point(pixel, b.z, view) - point_)) * scale_;
  }

 private:
  const ViewGeometry& views_;
  Vec3f point_, normal_;
  float scale_;
};

}  // namespace

namespace {

/// The squared light of the brightest pixel but one of the same material within 7 x 7; infinite where these are too few.
float light_around(const std::vector<Texel>& texels, Vec2i size, int x, int y, std::size_t index) {
  constexpr int kReach = 3;
  float brightest = 0.0f, second = 0.0f;
  int neighbours = 0;
  for (int j = std::max(0, y - kReach); j <= std::min(size.y - 1, y + kReach); ++j)
    for (int i = std::max(0, x - kReach); i <= std::min(size.x - 1, x + kReach); ++i) {
      const std::size_t other = index + static_cast<std::ptrdiff_t>(j - y) * size.x + (i - x);
      const Texel& b = texels[other];
      if (other == index || !(b.met > 0.0f) || material_difference(texels[index], b) >= kSameMaterial) continue;
      const float light = squared_length(b.light);
      second = std::max(second, std::min(brightest, light));
      brightest = std::max(brightest, light);
      ++neighbours;
    }
  return neighbours < kLeastNeighbours ? std::numeric_limits<float>::infinity() : second;
}

}  // namespace

void clip_outliers(const ViewGeometry& views, const ThreadPool& pool, std::vector<Texel>& texels) {
  std::vector<float> share(texels.size(), 1.0f);
  for_each_pixel(views, pool, [&](int, int x, int y, std::size_t index) {
    const Texel& a = texels[index];
    const float light = squared_length(a.light);
    if (!(a.met > 0.0f) || a.variance < square(kOneHalf) * light) return;
    const float around = light_around(texels, views.view_size(), x, y, index);
    if (light > square(kBrighter) * around) share[index] = std::sqrt(around / light);
  });
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i].light *= share[i], texels[i].variance *= square(share[i]);
}

void make_guides(const ViewGeometry& views, const ThreadPool& pool, std::vector<Texel>& texels) {
  constexpr int kReach = 2;
  const Vec2i size = views.view_size();
  std::vector<float> pooled(texels.size());
  for_each_pixel(views, pool, [&](int view, int x, int y, std::size_t index) {
    Texel& a = texels[index];
    if (!(a.met > 0.0f)) return;
    const PlaneOf plane(views, a, Vec2f(x, y), view, kReach);
    Vec3f light(0.0f);
    float variance = 0.0f, weight = 0.0f, squares = 0.0f;
    for (int j = std::max(0, y - kReach); j <= std::min(size.y - 1, y + kReach); ++j)
      for (int i = std::max(0, x - kReach); i <= std::min(size.x - 1, x + kReach); ++i) {
        const Texel& b = texels[index + static_cast<std::ptrdiff_t>(j - y) * size.x + (i - x)];
        if (!(b.met > 0.0f)) continue;
        const float w = weight_of(material_difference(a, b) + plane.difference(b, Vec2f(i, j), view));
        light += w * b.light, variance += w * b.variance, weight += w, squares += w * w;
      }
    a.guide = light / weight;
    pooled[index] = variance / weight;
    a.guide_variance = pooled[index] * squares / (weight * weight);
  });
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i].variance = pooled[i];
}

namespace {

/// Averages what other views show of one pixel's point.
class Gatherer {
 public:
  Gatherer(const ViewGeometry& views, const Texel& texel) : a_(texel), size_(views.view_size()) {
    mean_.add(a_.light, a_.variance, 1.0f);
  }

  /// Adds the light that a view has at a place, between its four pixels.
  void add(const std::vector<Texel>& texels, int view, Vec2f place, const PlaneOf& plane) {
    const Vec2f corner = glm::floor(place), share = place - corner;
    const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
    if (!(place.x > -1.0f && place.y > -1.0f && x < size_.x && y < size_.y)) return;
    for (int k = 0; k < 4; ++k) {
      const int i = x + (k & 1), j = y + (k >> 1);
      if (i < 0 || j < 0 || i >= size_.x || j >= size_.y) continue;
      const float part = ((k & 1) != 0 ? share.x : 1.0f - share.x) * ((k >> 1) != 0 ? share.y : 1.0f - share.y);
      const Texel& b = texels[(static_cast<std::size_t>(view) * size_.y + j) * size_.x + i];
      if (!(part > 0.0f) || !(b.met > 0.0f)) continue;
      const float difference = material_difference(a_, b) +
                               light_difference(a_.guide, a_.guide_variance, b.guide, b.guide_variance) +
                               plane.difference(b, Vec2f(i, j), view);
      const float w = part * weight_of(difference);
      if (w > kLeastWeight) mean_.add(b.light, b.variance, w);
    }
  }

  Estimate finished() const { return mean_.finished(); }

 private:
  const Texel& a_;
  Vec2i size_;
  Mean mean_;
};

}  // namespace

std::vector<Estimate> gather(const ViewGeometry& views, const TexelFrame& frame, const ThreadPool& pool) {
  const ViewGrid& grid = views.grid();
  std::vector<Estimate> gathered(frame.texels.size());
  for_each_pixel(views, pool, [&](int view, int x, int y, std::size_t index) {
    const Texel& a = frame.texels[index];
    if (!(a.met > 0.0f)) return;
    Gatherer mean(views, a);
    const Vec2f pixel(x, y);
    const PlaneOf plane(views, a, pixel, view, 1.0f);
    const int column = view % grid.columns, row = view / grid.columns;
    for (int d = -kViewReach; d <= kViewReach; ++d) {
      if (d == 0) continue;
      if (column + d >= 0 && column + d < grid.columns)
        mean.add(frame.texels, view + d, views.moved(pixel, a.z, view, view + d), plane);
      const int other = view + d * grid.columns;
      if (row + d >= 0 && row + d < grid.rows) mean.add(frame.texels, other, views.moved(pixel, a.z, view, other), plane);
    }
    gathered[index] = mean.finished();
  });
  return gathered;
}

std::vector<Estimate> smooth(const ViewGeometry& views, const std::vector<Texel>& texels, const std::vector<Estimate>& light,
                             int step, const ThreadPool& pool) {
  constexpr std::array<float, 5> kSpline{1.0f / 16, 1.0f / 4, 3.0f / 8, 1.0f / 4, 1.0f / 16};
  const Vec2i size = views.view_size();
  std::vector<Estimate> smoothed(light.size());
  for_each_pixel(views, pool, [&](int view, int x, int y, std::size_t index) {
    const Texel& a = texels[index];
    if (!(a.met > 0.0f)) return;
    const PlaneOf plane(views, a, Vec2f(x, y), view, static_cast<float>(step));
    Mean mean;
    for (int dj = -2; dj <= 2; ++dj)
      for (int di = -2; di <= 2; ++di) {
        const int i = x + di * step, j = y + dj * step;
        if (i < 0 || j < 0 || i >= size.x || j >= size.y) continue;
        const std::size_t other = index + static_cast<std::ptrdiff_t>(dj * step) * size.x + di * step;
        const Texel& b = texels[other];
        if (!(b.met > 0.0f)) continue;
        const float part = kSpline[static_cast<std::size_t>(di + 2)] * kSpline[static_cast<std::size_t>(dj + 2)];
        const Estimate &p = light[index], &q = light[other];
        const float w = part * weight_of(material_difference(a, b) + plane.difference(b, Vec2f(i, j), view) +
                                         light_difference(p.light, p.variance, q.light, q.variance));
        mean.add(q.light, q.variance, w * influence(p.variance, q.variance));
      }
    smoothed[index] = mean.finished();
  });
  return smoothed;
}

void take_back_blur(const ViewGeometry& views, const std::vector<Texel>& texels, std::vector<Estimate>& filtered,
                    const ThreadPool& pool) {
  constexpr int kReach = 3;
  const Vec2i size = views.view_size();
  std::vector<float> share(texels.size());  // how much of the change stays
  for_each_pixel(views, pool, [&](int, int x, int y, std::size_t index) {
    float change = 0.0f, variance = 0.0f;
    for (int j = std::max(0, y - kReach); j <= std::min(size.y - 1, y + kReach); ++j)
      for (int i = std::max(0, x - kReach); i <= std::min(size.x - 1, x + kReach); ++i) {
        const std::size_t other = index + static_cast<std::ptrdiff_t>(j - y) * size.x + (i - x);
        if (!(texels[other].met > 0.0f)) continue;
        change += squared_length(filtered[other].light - texels[other].light);
        variance += texels[other].variance;
      }
    share[index] = change > kExplained * variance ? kExplained * variance / change : 1.0f;
  });
  for (std::size_t i = 0; i < filtered.size(); ++i)
    filtered[i].light = texels[i].light + share[i] * (filtered[i].light - texels[i].light);
}

}  // namespace lippmann
