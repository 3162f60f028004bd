#include "optics/eye_blur.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "lippmann/optics/crosstalk.hpp"

namespace lippmann {
namespace {

/// Neighbours that are less of the picture do not show.
constexpr double kLeastWeight = 1e-3;

double at(const std::vector<double>& by_distance, int step) {
  const auto distance = static_cast<std::size_t>(std::abs(step));
  return distance < by_distance.size() ? by_distance[distance] : 0.0;
}

/// The sum over both directions.
double total(const std::vector<double>& by_distance) {
  double sum = by_distance[0];
  for (std::size_t i = 1; i < by_distance.size(); ++i) sum += 2.0 * by_distance[i];
  return sum;
}

std::vector<double> overlaps_of(const std::vector<double>& weights) {
  const int reach = static_cast<int>(weights.size()) - 1;
  std::vector<double> overlaps;
  for (int step = 0; step <= 2 * reach; ++step) {
    double sum = 0.0;
    for (int i = -reach; i <= reach; ++i) sum += at(weights, i) * at(weights, i - step);
    overlaps.push_back(sum);
  }
  return overlaps;
}

}  // namespace

EyeBlur::Axis EyeBlur::make_axis(double sigma_px) {
  Axis axis;
  if (!(sigma_px > 0.0)) return axis;
  axis.weights.clear();
  for (const Tap& tap : gaussian_taps(0.5, sigma_px))
    if (tap.index == 0 || (tap.index > 0 && tap.weight >= kLeastWeight)) axis.weights.push_back(tap.weight);
  const double sum = total(axis.weights);
  for (double& weight : axis.weights) weight /= sum;
  axis.overlaps = overlaps_of(axis.weights);
  return axis;
}

EyeBlur::EyeBlur(const Optics& optics, double sigma_px)
    : size_(film_size(optics)), stride_(sub_pixels_per_pixel(optics)), tiles_(view_tiles(optics)) {
  const Vec2d sigmas = sigma_px > 0.0 ? crosstalk_sigmas(optics, sigma_px) : Vec2d(0.0);
  across_ = make_axis(sigmas.x), up_ = make_axis(sigmas.y);
  if (!tiles_) return;
  tile_ = {size_.x / tiles_->columns, size_.y / tiles_->rows};
  padding_top_ = size_.y - tiles_->rows * tile_.y;
}

Vec2i EyeBlur::reach() const {
  return {static_cast<int>(across_.weights.size()) - 1, static_cast<int>(up_.weights.size()) - 1};
}

double EyeBlur::weight(Vec2i step) const { return at(across_.weights, step.x) * at(up_.weights, step.y); }

double EyeBlur::overlap(Vec2i step) const { return at(across_.overlaps, step.x) * at(up_.overlaps, step.y); }

std::optional<std::uint32_t> EyeBlur::neighbour(std::uint32_t pixel, Vec2i step) const {
  if (step == Vec2i(0)) return pixel;
  const auto inside = [](Vec2i p, Vec2i size) { return p.x >= 0 && p.y >= 0 && p.x < size.x && p.y < size.y; };
  Vec2i place(static_cast<int>(pixel) % size_.x, static_cast<int>(pixel) / size_.x);
  if (!tiles_) {
    place += Vec2i(step.x * stride_, step.y);
    if (!inside(place, size_)) return std::nullopt;
  } else {
    const Vec2i count(tiles_->columns, tiles_->rows), tile((place.x) / tile_.x, (place.y - padding_top_) / tile_.y);
    if (place.y < padding_top_ || !inside(tile, count)) return std::nullopt;
    Vec2i view(tile.x, count.y - 1 - tile.y);  // rows count from below
    if (tiles_->camera_grid) {
      view += step;
    } else {
      const int v = view.y * count.x + view.x + step.x;
      view = v >= 0 ? Vec2i(v % count.x, v / count.x) : Vec2i(-1);
    }
    if (!inside(view, count)) return std::nullopt;
    place += (Vec2i(view.x, count.y - 1 - view.y) - tile) * tile_;
  }
  return static_cast<std::uint32_t>(place.y) * static_cast<std::uint32_t>(size_.x) + static_cast<std::uint32_t>(place.x);
}

int EyeBlur::draw(const Axis& axis, double random) {
  const int most = static_cast<int>(axis.overlaps.size()) - 1;
  double left = random * total(axis.overlaps);
  for (int step = -most; step < most; ++step) {
    left -= at(axis.overlaps, step);
    if (left < 0.0) return step;
  }
  return most;
}

Vec2i EyeBlur::draw_overlapping(Vec2d random) const { return {draw(across_, random.x), draw(up_, random.y)}; }

}  // namespace lippmann
