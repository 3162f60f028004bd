// Based on: Wang, Simoncelli, Bovik, "Multi-scale structural similarity for image quality assessment", Asilomar Conference on
// Signals, Systems and Computers, 2003, equation 7 and the weights of section 3.2.
//
// 1. Each scale is computed from the next finer scale by averaging 2 x 2 pixels.
// 2. The factor of a scale is its mean contrast and structure term, raised to the scale's weight. For the coarsest scale, the
//    mean SSIM replaces the term.
// 3. MS-SSIM is the product of all factors.
//
// We deviate: a negative mean counts as 0, because fractional powers of negative numbers are not real.
#include "image/ms_ssim.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "image/ssim.hpp"

namespace lippmann {
namespace {

constexpr std::array<double, 5> kScaleWeights{0.0448, 0.2856, 0.3001, 0.2363, 0.1333};

/// Repeats the last row or column if their number is odd.
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
