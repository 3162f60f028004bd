#include "replay/depth_order.hpp"

#include <cmath>

#include "lippmann/core/math.hpp"

namespace lippmann {
namespace {

double difference(const float* color, const Image& picture, double x, int y) {
  const int left = static_cast<int>(std::floor(x));
  const float share = static_cast<float>(x - left);
  const float *a = picture.pixel(left, y), *b = picture.pixel(std::min(left + 1, picture.width - 1), y);
  double sum = 0.0;
  for (int c = 0; c < 3; ++c) {
    const double d = color[c] - ((1.0f - share) * a[c] + share * b[c]);
    sum += d * d;
  }
  return sum;
}

struct Sums {
  double right = 0.0, wrong = 0.0;
  int pixels = 0;

  double db() const {
    constexpr double kMin = 1e-12;  ///< avoids a division by 0
    return 10.0 * std::log10((wrong + kMin) / (right + kMin));
  }
};

}  // namespace

DepthOrder measure_depth_order(const Image& view, const Image& other, const Image& depth, double eye_z_mm, double baseline_mm,
                               double pixel_mm) {
  Sums behind, front;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      const double z = *depth.pixel(x, y);
      if (!std::isfinite(z) || z >= eye_z_mm) continue;
      const double shift = -baseline_mm * z / (eye_z_mm - z) / pixel_mm;
      if (std::abs(shift) < 1.0 || x - std::abs(shift) < 0.0 || x + std::abs(shift) > view.width - 1) continue;
      Sums& sums = z < 0.0 ? behind : front;
      sums.right += difference(view.pixel(x, y), other, x + shift, y);
      sums.wrong += difference(view.pixel(x, y), other, x - shift, y);
      ++sums.pixels;
    }
  return {behind.db(), front.db(), behind.pixels, front.pixels};
}

}  // namespace lippmann
