// Based on: Lai, Huang, Wang, Shechtman, Yumer, Yang, "Learning blind video temporal consistency", ECCV 2018, equation 3 (the
// weight of a pixel) and section 4.2 (the warping error).
//
// Flicker: the error of a pixel p at time t is e_t(p) = test - reference. The change of the error along the motion of the
// surface is e_t(p) - e_{t-1}(p - motion(p)), with bilinear interpolation. The weight of a pixel is exp(-50 |a_t - a_{t-1}|^2),
// where a is the reference's colour in 0 ... 1.
//
// Angular consistency compares the differences between neighbouring views, as the metric tLP compares neighbouring frames: Chu,
// Xie, Mayer, Leal-Taixe, Thuerey, "Learning temporal coherence via self-supervision for GAN-based video generation", ACM
// Trans. Graphics 39(4), 2020, section 5.2.
//
// We deviate:
// 1. The motion of every pixel is known, so there is no optical flow and no occlusion mask.
// 2. The warping error is computed from the difference to the reference, so the reference itself scores 0.
// 3. Views are compared by codes, not by features of a network.
#include "compare/consistency.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "lippmann/image/metrics.hpp"

namespace lippmann {
namespace {

constexpr double kVisibilityFall = 50.0;

double squared_changes(const Image8& a0, const Image8& a1, const Image8& b0, const Image8& b1) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < a0.rgb.size(); ++i) {
    const int change = (int{a1.rgb[i]} - a0.rgb[i]) - (int{b1.rgb[i]} - b0.rgb[i]);
    sum += static_cast<std::uint64_t>(change * change);
  }
  return static_cast<double>(sum);
}

struct BilinearTaps {
  std::array<std::size_t, 4> pixels;
  std::array<double, 4> weights;
};

bool find_taps(double x, double y, const Image8& image, BilinearTaps& taps) {
  if (!(x >= 0.0 && y >= 0.0 && x <= image.width - 1 && y <= image.height - 1)) return false;
  const std::size_t width = static_cast<std::size_t>(image.width), x0 = static_cast<std::size_t>(x),
                    y0 = static_cast<std::size_t>(y), x1 = std::min(x0 + 1, width - 1),
                    y1 = std::min(y0 + 1, static_cast<std::size_t>(image.height) - 1);
  const double u = x - static_cast<double>(x0), v = y - static_cast<double>(y0);
  taps.pixels = {y0 * width + x0, y0 * width + x1, y1 * width + x0, y1 * width + x1};
  taps.weights = {(1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v};
  return true;
}

double sample(const Image8& image, const BilinearTaps& taps, std::size_t channel) {
  double sum = 0.0;
  for (std::size_t t = 0; t < taps.pixels.size(); ++t) sum += taps.weights[t] * image.rgb[3 * taps.pixels[t] + channel];
  return sum;
}

}  // namespace

double angular_psnr_db(const std::vector<Image8>& reference, const std::vector<Image8>& test, ViewGrid grid) {
  double squares = 0.0, samples = 0.0;
  const auto add_pair = [&](int v, int w) {
    const std::size_t i = static_cast<std::size_t>(v), j = static_cast<std::size_t>(w);
    squares += squared_changes(reference[i], reference[j], test[i], test[j]);
    samples += static_cast<double>(reference[i].rgb.size());
  };
  for (int v = 0; v < grid.count(); ++v) {
    if (v % grid.columns + 1 < grid.columns) add_pair(v, v + 1);
    if (v + grid.columns < grid.count()) add_pair(v, v + grid.columns);
  }
  return samples > 0.0 ? psnr_db(squares / samples) : std::numeric_limits<double>::quiet_NaN();
}

FlickerSums flicker_of_view(const ViewChange& change) {
  FlickerSums sums;
  BilinearTaps taps{};
  for (int y = 0; y < change.reference.height; ++y)
    for (int x = 0; x < change.reference.width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * change.reference.width + x;
      const double from_x = x - double{change.motion[2 * i]}, from_y = y - double{change.motion[2 * i + 1]};
      if (!find_taps(from_x, from_y, change.reference, taps)) continue;
      double reference_change = 0.0, error_change = 0.0;
      for (std::size_t c = 0; c < 3; ++c) {
        const double a0 = sample(change.reference_before, taps, c), b0 = sample(change.test_before, taps, c);
        const double a1 = change.reference.rgb[3 * i + c], b1 = change.test.rgb[3 * i + c];
        reference_change += (a1 - a0) * (a1 - a0) / (255.0 * 255.0);
        error_change += (b1 - a1 - (b0 - a0)) * (b1 - a1 - (b0 - a0));
      }
      const double weight = std::exp(-kVisibilityFall * reference_change);
      sums.squares += weight * error_change;
      sums.weights += 3.0 * weight;
    }
  return sums;
}

double flicker_of(const FlickerSums& sums) { return std::sqrt(sums.squares / sums.weights); }

}  // namespace lippmann
