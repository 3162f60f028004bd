// Pearson's chi-squared test, over a grid of the sphere, of whether random directions follow a density.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann::test {

struct ChiSquared {
  double statistic = 0.0;
  int degrees_of_freedom = 0;
  /// Returns by how many standard deviations the statistic exceeds its mean, by Wilson and Hilferty's transform. The
  /// probability of 4 or more is 1 in 30,000.
  double deviations() const {
    const double n = degrees_of_freedom, t = 2.0 / (9.0 * n);
    return (std::cbrt(statistic / n) - (1.0 - t)) / std::sqrt(t);
  }
};

/// Tests directions against a density per steradian. `draw(i)` returns the i-th of `count` directions, or nothing.
/// Cells with fewer than 8 expected samples are merged.
inline ChiSquared chi_squared(int count, const std::function<std::optional<Vec3f>(int)>& draw,
                              const std::function<double(Vec3f)>& density) {
  // Number of cells, and number of quadrature points along each side of a cell.
  constexpr int kPolar = 24, kAzimuth = 48, kWithin = 12;
  std::vector<double> expected(kPolar * kAzimuth), found(kPolar * kAzimuth);
  for (int c = 0; c < kPolar * kAzimuth; ++c)
    for (int i = 0; i < kWithin * kWithin; ++i) {
      const double z = 1.0 - 2.0 * (c / kAzimuth + (i / kWithin + 0.5) / kWithin) / kPolar;
      const double angle = 2.0 * M_PI * (c % kAzimuth + (i % kWithin + 0.5) / kWithin) / kAzimuth;
      const double sine = std::sqrt(1.0 - z * z);
      const Vec3f d(static_cast<float>(sine * std::cos(angle)), static_cast<float>(sine * std::sin(angle)),
                    static_cast<float>(z));
      expected[static_cast<std::size_t>(c)] += density(d) * 4.0 * M_PI / (kPolar * kAzimuth * kWithin * kWithin) * count;
    }
  for (int i = 0; i < count; ++i) {
    const std::optional<Vec3f> d = draw(i);
    if (!d) continue;
    const int polar = std::min(kPolar - 1, static_cast<int>((1.0 - static_cast<double>(d->z)) * 0.5 * kPolar));
    const double turn = std::atan2(d->y, d->x) / (2.0 * M_PI);
    const int azimuth = std::min(kAzimuth - 1, static_cast<int>((turn - std::floor(turn)) * kAzimuth));
    ++found[static_cast<std::size_t>(polar * kAzimuth + azimuth)];
  }
  ChiSquared result;
  double rare_expected = 0.0, rare_found = 0.0;
  const auto add = [&](double e, double f) { result.statistic += (f - e) * (f - e) / e, ++result.degrees_of_freedom; };
  for (std::size_t c = 0; c < expected.size(); ++c) {
    if (expected[c] >= 8.0) {
      add(expected[c], found[c]);
    } else {
      rare_expected += expected[c], rare_found += found[c];
    }
  }
  if (rare_expected >= 8.0) add(rare_expected, rare_found);
  return result;
}

}  // namespace lippmann::test
