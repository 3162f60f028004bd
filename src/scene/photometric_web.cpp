#include "scene/photometric_web.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lippmann {
namespace {

/// Tolerance in radians, so that rounding does not lose directions at the ends of the measured range.
constexpr float kAngleMargin = 1e-5f;

/// An angle in the grid: grid angle `first` plus the fraction `share` of the step to the next grid angle.
struct WebPlace {
  std::size_t first;
  float share;
};

std::optional<WebPlace> place_in(const std::vector<float>& numbers, float x) {
  if (!(x >= numbers.front() - kAngleMargin && x <= numbers.back() + kAngleMargin)) return std::nullopt;
  const auto above = std::upper_bound(numbers.begin() + 1, numbers.end() - 1, x);
  const auto first = static_cast<std::size_t>(above - numbers.begin()) - 1;
  return WebPlace{first, std::clamp((x - numbers[first]) / (numbers[first + 1] - numbers[first]), 0.0f, 1.0f)};
}

float along_polar(const PhotometricWeb& web, std::size_t azimuth, const WebPlace& at) {
  const float* row = web.intensity.data() + azimuth * web.polar.size() + at.first;
  return row[0] + at.share * (row[1] - row[0]);
}

/// Integrals of weight * sine over a range of polar angles. The weight is linear: from 1 to 0 for `falling`, from 0 to 1 for
/// `rising`.
struct PolarWeights {
  double falling, rising;
};

PolarWeights polar_weights(double from, double to) {
  const double whole = std::cos(from) - std::cos(to);
  const double rising = (std::sin(to) - std::sin(from)) / (to - from) - std::cos(to);
  return {whole - rising, rising};
}

double polar_integral(const PhotometricWeb& web, std::size_t azimuth) {
  const float* row = web.intensity.data() + azimuth * web.polar.size();
  double sum = 0.0;
  for (std::size_t j = 0; j + 1 < web.polar.size(); ++j) {
    const PolarWeights weights = polar_weights(static_cast<double>(web.polar[j]), static_cast<double>(web.polar[j + 1]));
    sum += weights.falling * static_cast<double>(row[j]) + weights.rising * static_cast<double>(row[j + 1]);
  }
  return sum;
}

}  // namespace

float intensity(const PhotometricWeb& web, Vec3f direction) {
  const Vec3f d = web.web_from_light * direction;
  const auto polar = place_in(web.polar, std::acos(std::clamp(d.z, -1.0f, 1.0f)));
  if (!polar) return 0.0f;
  if (web.azimuth.size() == 1) return along_polar(web, 0, *polar);
  float angle = std::atan2(d.y, d.x);
  if (angle < web.azimuth.front() - kAngleMargin) angle += 2.0f * kPi;
  if (angle > web.azimuth.back() + kAngleMargin) angle -= 2.0f * kPi;
  const auto azimuth = place_in(web.azimuth, angle);
  if (!azimuth) return 0.0f;
  const float first = along_polar(web, azimuth->first, *polar), second = along_polar(web, azimuth->first + 1, *polar);
  return first + azimuth->share * (second - first);
}

double mean_intensity(const PhotometricWeb& web) {
  if (web.azimuth.size() == 1) return 0.5 * polar_integral(web, 0);
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < web.azimuth.size(); ++i)
    sum += 0.5 * (polar_integral(web, i) + polar_integral(web, i + 1)) *
           (static_cast<double>(web.azimuth[i + 1]) - static_cast<double>(web.azimuth[i]));
  return sum / (4.0 * M_PI);
}

}  // namespace lippmann
