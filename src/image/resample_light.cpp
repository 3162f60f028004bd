// Based on: K. Turkowski, Filters for Common Resampling Tasks, Graphics Gems I, 1990. The Lanczos filter is a sinc, multiplied
// by the main lobe of a sinc 3 times as wide.
//
// We deviate: downsampling uses a box filter. A wide Lanczos filter would cause halos beside edges, which a lens array would
// show as false depth.
#include "image/resample_light.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann {
namespace {

constexpr double kLobes = 3.0;

/// Weights of the input samples first, first + 1, ..., which sum to 1. Without weights, the output is black.
struct TapWeights {
  int first = 0;
  std::vector<float> weights;
};

double sinc(double x) {
  const double angle = std::numbers::pi * x;
  return std::abs(angle) < 1e-9 ? 1.0 : std::sin(angle) / angle;
}

double lanczos(double x) { return std::abs(x) < kLobes ? sinc(x) * sinc(x / kLobes) : 0.0; }

/// Normalises the weights. Weights of samples outside 0 ... size - 1 are added to the first or last sample.
TapWeights within(int first, const std::vector<double>& weights, int size) {
  double sum = 0.0;
  for (const double weight : weights) sum += weight;
  TapWeights taps{std::clamp(first, 0, size - 1), {}};
  const int last = std::clamp(first + static_cast<int>(weights.size()) - 1, 0, size - 1);
  std::vector<double> moved(static_cast<std::size_t>(last - taps.first) + 1);
  for (std::size_t k = 0; k < weights.size(); ++k)
    moved[static_cast<std::size_t>(std::clamp(first + static_cast<int>(k), 0, size - 1) - taps.first)] += weights[k] / sum;
  for (const double weight : moved) taps.weights.push_back(static_cast<float>(weight));
  return taps;
}

TapWeights taps_of(const AxisSamples& axis, int i, int size) {
  const double begin = axis.first + i * axis.step, end = begin + axis.step, centre = 0.5 * (begin + end);
  if (axis.black_outside && (centre < 0.0 || centre > size)) return {};
  std::vector<double> weights;
  if (axis.step < 1.0) {
    const int first = static_cast<int>(std::ceil(centre - kLobes - 0.5));
    for (int k = first; k + 0.5 < centre + kLobes; ++k) weights.push_back(lanczos(k + 0.5 - centre));
    return within(first, weights, size);
  }
  // If the output sample ends exactly between two input samples, rounding must not add a tiny part of the next input sample.
  constexpr double kRounding = 1e-9;
  const int first = static_cast<int>(std::floor(begin + kRounding));
  for (int k = first; k < end - kRounding; ++k) weights.push_back(std::min(k + 1.0, end) - std::max<double>(k, begin));
  return within(first, weights, size);
}

std::vector<TapWeights> taps_of_axis(const AxisSamples& axis, int size) {
  std::vector<TapWeights> all;
  for (int i = 0; i < axis.count; ++i) all.push_back(taps_of(axis, i, size));
  return all;
}

class LightRows {
 public:
  explicit LightRows(const Picture& picture) : picture_(picture) {
    if (std::holds_alternative<Image8>(picture)) fill(256);
    if (std::holds_alternative<Image16>(picture)) fill(65536);
  }

  void read(int y, std::vector<float>& row) const {
    if (const auto* bytes = std::get_if<Image8>(&picture_)) return decode(bytes->rgb, y, row);
    if (const auto* words = std::get_if<Image16>(&picture_)) return decode(words->rgb, y, row);
    const float* from = std::get<Image>(picture_).pixel(0, y);
    std::transform(from, from + row.size(), row.begin(), [](float value) { return std::isfinite(value) ? value : 0.0f; });
  }

 private:
  void fill(std::size_t codes) {
    for (std::size_t i = 0; i < codes; ++i)
      light_.push_back(static_cast<float>(linear_from_srgb(static_cast<double>(i) / (static_cast<double>(codes) - 1.0))));
  }

  template <class Code>
  void decode(const std::vector<Code>& codes, int y, std::vector<float>& row) const {
    const Code* from = codes.data() + static_cast<std::size_t>(y) * row.size();
    std::transform(from, from + row.size(), row.begin(), [this](Code code) { return light_[code]; });
  }

  const Picture& picture_;
  std::vector<float> light_;
};

void weigh_row(const std::vector<float>& row, const std::vector<TapWeights>& taps, float* out) {
  for (const TapWeights& sample : taps) {
    float r = 0.0f, g = 0.0f, b = 0.0f;
    const float* from = row.data() + 3 * static_cast<std::size_t>(sample.first);
    for (const float weight : sample.weights) r += weight * from[0], g += weight * from[1], b += weight * from[2], from += 3;
    out[0] = r, out[1] = g, out[2] = b, out += 3;
  }
}

}  // namespace

Image resampled_light(const Picture& picture, const AxisSamples& across, const AxisSamples& down, const ThreadPool& pool) {
  const Vec2i size = std::visit([](const auto& image) { return Vec2i(image.width, image.height); }, picture);
  const std::vector<TapWeights> columns = taps_of_axis(across, size.x), rows = taps_of_axis(down, size.y);
  int begin = size.y, end = 0;
  for (const TapWeights& taps : rows) {
    if (taps.weights.empty()) continue;
    begin = std::min(begin, taps.first), end = std::max(end, taps.first + static_cast<int>(taps.weights.size()));
  }
  Image narrow(across.count, std::max(0, end - begin), 3);
  const LightRows light(picture);
  constexpr std::size_t kRowsAtOnce = 16;
  pool.for_each((static_cast<std::size_t>(narrow.height) + kRowsAtOnce - 1) / kRowsAtOnce, [&](std::size_t block) {
    std::vector<float> row(3 * static_cast<std::size_t>(size.x));
    const int first = static_cast<int>(block * kRowsAtOnce),
              last = std::min(narrow.height, first + static_cast<int>(kRowsAtOnce));
    for (int y = first; y < last; ++y) light.read(begin + y, row), weigh_row(row, columns, narrow.pixel(0, y));
  });
  Image result(across.count, down.count, 3);
  pool.for_each(rows.size(), [&](std::size_t y) {
    const TapWeights& taps = rows[y];
    float* out = result.pixel(0, static_cast<int>(y));
    for (std::size_t k = 0; k < taps.weights.size(); ++k) {
      const float* from = narrow.pixel(0, taps.first - begin + static_cast<int>(k));
      for (int i = 0; i < 3 * result.width; ++i) out[i] += taps.weights[k] * from[i];
    }
  });
  return result;
}

}  // namespace lippmann
