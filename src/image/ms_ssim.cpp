// Based on: Wang, Simoncelli, Bovik, "Multi-scale structural similarity for image quality assessment", Asilomar Conference on
// Signals, Systems and Computers, 2003, equation 7 and the weights of section 3.2.
//
// Each scale is made from the previous scale by averaging 2 x 2 pixels. MS-SSIM is a product with one factor for each scale:
// the mean contrast and structure term, to the power of the scale's weight. The factor of the coarsest scale uses the mean SSIM
// instead.
//
// We deviate:
// 1. A negative mean counts as 0, since its power is not real.
#include "image/ms_ssim.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "image/ssim.hpp"

namespace lippmann {
namespace {

constexpr std::array<double, 5> kScaleWeights{0.0448, 0.2856, 0.3001, 0.2363, 0.1333};

/// Averages 2 x 2 pixels. An odd last row or column is repeated.
SamplePlane half_size(const SamplePlane& plane) {
  SamplePlane half{(plane.width + 1) / 2, (plane.height + 1) / 2, {}};
  half.samples.reserve(static_cast<std::size_t>(half.width) * half.height);
  for (int y = 0; y < plane.height; y += 2) {
    const int below = std::min(y + 1, plane.height - 1);
    for (int x = 0; x < plane.width; x += 2) {
      const int right = std::min(x + 1, plane.width - 1);
      half.samples.push_back((plane.at(x, y) + plane.at(right, y) + plane.at(x, below) + plane.at(right, below)) / 4.0);
    }
  }
  return half;
}

}  // namespace

double ms_ssim(const Image8& reference, const Image8& test) {
  SamplePlane a = luma_601(reference), b = luma_601(test);
  double product = 1.0;
  for (std::size_t scale = 0; scale < kScaleWeights.size(); ++scale) {
    const bool is_last = scale + 1 == kScaleWeights.size();
    const double similarity = is_last ? ssim(a, b) : contrast_structure(a, b);
    if (std::isnan(similarity)) return std::numeric_limits<double>::quiet_NaN();
    product *= std::pow(std::max(similarity, 0.0), kScaleWeights[scale]);
    if (!is_last) a = half_size(a), b = half_size(b);
  }
  return product;
}

}  // namespace lippmann
