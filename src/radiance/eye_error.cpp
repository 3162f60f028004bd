#include "radiance/eye_error.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "core/random.hpp"
#include "radiance/measured_codes.hpp"
#include "trace/trace_pixels.hpp"

namespace lippmann {
namespace {

/// Neighbours of a measured pixel that are traced, by so much of a whole frame's paths each: together as many paths as one set
/// of the pixel itself has.
constexpr std::uint32_t kPartners = 4;

template <class Fn>
void for_each_step(Vec2i reach, const Fn& fn) {
  for (int y = -reach.y; y <= reach.y; ++y)
    for (int x = -reach.x; x <= reach.x; ++x) fn(Vec2i(x, y));
}

/// The squared slope of codes at what an eye sees at a pixel, over the square of the weights that lie within the film.
std::array<float, 3> slopes_at(const EyeBlur& blur, const Image& film, std::uint32_t pixel) {
  Vec3d sum(0.0);
  double weights = 0.0;
  for_each_step(blur.reach(), [&](Vec2i step) {
    const auto at = blur.neighbour(pixel, step);
    if (!at) return;
    const float* light = &film.data[3 * static_cast<std::size_t>(*at)];
    const double weight = blur.weight(step);
    for (int c = 0; c < 3; ++c) sum[c] += weight * static_cast<double>(shown_light(light[c]));
    weights += weight;
  });
  std::array<float, 3> slopes{};
  for (int c = 0; c < 3; ++c) {
    const double slope = slope_of_code(sum[c] / weights) / weights;
    slopes[static_cast<std::size_t>(c)] = static_cast<float>(slope * slope);
  }
  return slopes;
}

std::vector<float> shown_light_at(const Image& film, std::span<const std::uint32_t> pixels) {
  std::vector<float> light = light_at(film, pixels);
  for (float& v : light) v = shown_light(v);
  return light;
}

/// squared(p, c): of channel c of measured pixel p.
template <class Squared>
PixelError mean_over(const MeasuredPixels& where, const Squared& squared) {
  MeanOf pixels;
  for (std::size_t p = 0; p < where.pixels.size(); ++p)
    pixels.add(where.weights[p] * (squared(p, 0) + squared(p, 1) + squared(p, 2)) / 3.0);
  return {pixels.mean(), pixels.uncertainty()};
}

double half_square(float a, float b) {
  const auto d = static_cast<double>(shown_light(a)) - static_cast<double>(shown_light(b));
  return 0.5 * d * d;
}

std::size_t value(std::size_t pixel, int channel) { return 3 * pixel + static_cast<std::size_t>(channel); }

/// B_kk by measured pixel.
std::vector<Vec3d> own_weights(const EyeWeights& weights, const PixelMeasure& pixels) {
  std::vector<Vec3d> own;
  for (const std::uint32_t pixel : pixels.where().pixels) own.push_back(weights.of_pair(pixel, Vec2i(0)));
  return own;
}

PixelError of_independent(const std::vector<Vec3d>& own, const PixelMeasure& pixels, const std::vector<float>& light) {
  return mean_over(pixels.where(), [&](std::size_t p, int c) {
    return own[p][c] * half_square(light[value(p, c)], pixels.light(0)[value(p, c)]);
  });
}

}  // namespace

EyeWeights::EyeWeights(const EyeBlur& blur, const Image& film, const ThreadPool& pool)
    : blur_(blur), slopes_(film.width, film.height, 3) {
  pool.for_each(static_cast<std::size_t>(film.height), [&](std::size_t row) {
    const std::size_t width = static_cast<std::size_t>(film.width);
    for (std::size_t pixel = row * width; pixel < (row + 1) * width; ++pixel) {
      const std::array<float, 3> slopes = slopes_at(blur_, film, static_cast<std::uint32_t>(pixel));
      std::copy(slopes.begin(), slopes.end(), slopes_.data.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
    }
  });
}

Vec3d EyeWeights::of_pair(std::uint32_t pixel, Vec2i step) const {
  Vec3d sum(0.0);
  if (!blur_.neighbour(pixel, step)) return sum;
  for_each_step(blur_.reach(), [&](Vec2i seen_at) {
    const double weight = blur_.weight(seen_at) * blur_.weight(seen_at - step);
    const auto at = weight > 0.0 ? blur_.neighbour(pixel, seen_at) : std::nullopt;
    if (!at) return;
    for (int c = 0; c < 3; ++c) sum[c] += weight * static_cast<double>(slopes_.data[value(*at, c)]);
  });
  return sum;
}

EyeMeasure::EyeMeasure(const EyeWeights& weights, const PixelMeasure& pixels, const Shot& shot, const TraceParams& trace,
                       const Workers& workers)
    : pixels_(pixels), own_(own_weights(weights, pixels)), of_(pixels.where().pixels.size()) {
  if (!weights.blur().blurs()) return;
  draw_partners(weights, hash(trace.seed, trace.frame, 0x65796573u));
  trace_partners(shot, trace, workers);
}

/// A pixel's neighbours are drawn by how much is seen of them together with it. Those that fall on the pixel itself, or beyond
/// the film, contribute nothing.
void EyeMeasure::draw_partners(const EyeWeights& weights, std::uint32_t seed) {
  const EyeBlur& blur = weights.blur();
  const std::vector<std::uint32_t>& pixels = pixels_.where().pixels;
  std::vector<std::vector<std::uint32_t>> drawn(pixels.size());
  for (std::size_t p = 0; p < pixels.size(); ++p)
    for (std::uint32_t i = 0; i < kPartners; ++i) {
      const float along = (static_cast<float>(i) + unit_float(hash(seed, pixels[p], i, 0))) / kPartners;
      const Vec2i step = blur.draw_overlapping({along, unit_float(hash(seed, pixels[p], i, 1))});
      const auto partner = step == Vec2i(0) ? std::nullopt : blur.neighbour(pixels[p], step);
      if (!partner) continue;
      of_[p].push_back({0, weights.of_pair(pixels[p], step) / (kPartners * blur.overlap(step))});
      drawn[p].push_back(*partner), partners_.push_back(*partner);
    }
  std::sort(partners_.begin(), partners_.end());
  partners_.erase(std::unique(partners_.begin(), partners_.end()), partners_.end());
  for (std::size_t p = 0; p < pixels.size(); ++p)
    for (std::size_t i = 0; i < of_[p].size(); ++i)
      of_[p][i].place =
          static_cast<std::size_t>(std::lower_bound(partners_.begin(), partners_.end(), drawn[p][i]) - partners_.begin());
}

void EyeMeasure::trace_partners(const Shot& shot, TraceParams trace, const Workers& workers) {
  Image film(film_size(shot.optics).x, film_size(shot.optics).y, 3);
  trace.seed = hash(trace.seed, trace.frame, 0x65796570u);
  trace.spp = static_cast<int>(std::bit_floor(std::max(1u, static_cast<unsigned>(trace.spp) / kPartners)));
  add(trace_pixels(shot, trace, partners_, workers, film), counts_);
  light_ = shown_light_at(film, partners_);
}

PixelError EyeMeasure::of_paths() const { return of_independent(own_, pixels_, pixels_.light(1)); }

/// By how much the neighbours of a pixel are wrong, weighted. light: of all partners in the picture.
double EyeMeasure::of_neighbours(std::size_t pixel, int channel, const std::vector<float>& light) const {
  double sum = 0.0;
  for (const Partner& partner : of_[pixel]) {
    const std::size_t i = value(partner.place, channel);
    sum += partner.weight[channel] * static_cast<double>(light[i] - light_[i]);
  }
  return sum;
}

PixelError EyeMeasure::error_of(const Image& film) const {
  const std::vector<float> light = shown_light_at(film, pixels_.where().pixels), partners = shown_light_at(film, partners_);
  return mean_over(pixels_.where(), [&](std::size_t p, int c) {
    const std::size_t i = value(p, c);
    const auto of_set = [&](int set) {
      return static_cast<double>(light[i]) - static_cast<double>(shown_light(pixels_.light(set)[i]));
    };
    const double a = of_set(0), b = of_set(1);
    return own_[p][c] * a * b + 0.5 * (a + b) * of_neighbours(p, c, partners);
  });
}

PixelError eye_error_of_paths(const EyeWeights& weights, const PixelMeasure& pixels, const std::vector<float>& light) {
  return of_independent(own_weights(weights, pixels), pixels, light);
}

}  // namespace lippmann
