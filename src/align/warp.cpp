#include "align/warp.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace lippmann {
namespace {

constexpr int kTaps = 6, kPhases = 1024;
using Taps = std::array<float, kTaps>;

double lanczos(double x) {
  if (std::abs(x) < 1e-9) return 1.0;
  if (std::abs(x) >= 3.0) return 0.0;
  const double t = std::numbers::pi * x;
  return 3.0 * std::sin(t) * std::sin(t / 3.0) / (t * t);
}

std::array<Taps, kPhases + 1> tap_table() {
  std::array<Taps, kPhases + 1> table{};
  for (int phase = 0; phase <= kPhases; ++phase) {
    double sum = 0.0;
    std::array<double, kTaps> weights{};
    for (int tap = 0; tap < kTaps; ++tap)
      sum += weights[static_cast<std::size_t>(tap)] = lanczos(tap - 2 - static_cast<double>(phase) / kPhases);
    for (std::size_t tap = 0; tap < kTaps; ++tap)
      table[static_cast<std::size_t>(phase)][tap] =
          std::abs(weights[tap]) < 1e-9 ? 0.0f : static_cast<float>(weights[tap] / sum);
  }
  return table;
}

struct TapPlace {
  std::array<int, kTaps> pixels{};
  const Taps* weights = nullptr;

  TapPlace(double place, int size, const std::array<Taps, kPhases + 1>& table) {
    const double centred = std::clamp(place - 0.5, -1.0, static_cast<double>(size));
    const int low = static_cast<int>(std::floor(centred));
    weights = &table[static_cast<std::size_t>((centred - low) * kPhases + 0.5)];
    for (int tap = 0; tap < kTaps; ++tap) pixels[static_cast<std::size_t>(tap)] = std::clamp(low + tap - 2, 0, size - 1);
  }
};

void sample(const Image& picture, const TapPlace& across, const TapPlace& down, float* result) {
  std::array<float, 3> sum{};
  for (std::size_t row = 0; row < kTaps; ++row) {
    const float* pixels = picture.pixel(0, down.pixels[row]);
    std::array<float, 3> of_row{};
    for (std::size_t column = 0; column < kTaps; ++column) {
      const float* pixel = pixels + std::size_t{3} * across.pixels[column];
      const float weight = (*across.weights)[column];
      for (std::size_t c = 0; c < 3; ++c) of_row[c] += weight * pixel[c];
    }
    for (std::size_t c = 0; c < 3; ++c) sum[c] += (*down.weights)[row] * of_row[c];
  }
  for (std::size_t c = 0; c < 3; ++c) result[c] = std::max(sum[c], 0.0f);  // the filter's ringing can go below black
}

}  // namespace

Image warped(const Image& picture, const Similarity& aligned_from_picture, Vec2i corner, Vec2i size, const ThreadPool& pool) {
  static const std::array<Taps, kPhases + 1> table = tap_table();
  const Similarity back = inverse(aligned_from_picture);
  Image result(size.x, size.y, 3);
  pool.for_each(static_cast<std::size_t>(size.y), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < size.x; ++x) {
      const Vec2d place = back(Vec2d(corner) + Vec2d(x, y) + 0.5);
      sample(picture, TapPlace(place.x, picture.width, table), TapPlace(place.y, picture.height, table), result.pixel(x, y));
    }
  });
  return result;
}

}  // namespace lippmann
