// Based on: Wang, Bovik, Sheikh, Simoncelli, "Image quality assessment: from error visibility to structural similarity", IEEE
// Transactions on Image Processing 13(4), 2004, equations 13 to 16.
//
// With local means mu and (co)variances s^2 under the window,
//   SSIM = (2 mu_a mu_b + C1) (2 s_ab + C2) / ((mu_a^2 + mu_b^2 + C1) (s_a^2 + s_b^2 + C2)).
// Only the sum of the variances occurs, so the window sums of a, b, a^2 + b^2 and a b are enough. The window is separable.
#include "image/ssim.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "core/multiversion.hpp"

namespace lippmann {
namespace {

constexpr int kTaps = 11;
constexpr double kSigma = 1.5;
constexpr double kC1 = (0.01 * 255.0) * (0.01 * 255.0), kC2 = (0.03 * 255.0) * (0.03 * 255.0);

using Window = std::array<double, kTaps>;

Window gaussian() {
  Window window{};
  double sum = 0.0;
  for (int i = 0; i < kTaps; ++i) {
    const double x = i - kTaps / 2;
    sum += window[i] = std::exp(-x * x / (2.0 * kSigma * kSigma));
  }
  for (double& weight : window) weight /= sum;
  return window;
}

struct Sums {
  std::vector<double> a, b, squares, product;
  explicit Sums(std::size_t width) : a(width), b(width), squares(width), product(width) {}
};

LIPPMANN_MULTIVERSION void sum_down(const double* a, const double* b, int width, const Window& window, Sums& sums) {
  double *__restrict sa = sums.a.data(), *__restrict sb = sums.b.data(), *__restrict ss = sums.squares.data(),
                     *__restrict sp = sums.product.data();
  for (int x = 0; x < width; ++x) sa[x] = sb[x] = ss[x] = sp[x] = 0.0;
  for (int t = 0; t < kTaps; ++t, a += width, b += width) {
    const double w = window[t];
    for (int x = 0; x < width; ++x) {
      sa[x] += w * a[x];
      sb[x] += w * b[x];
      ss[x] += w * (a[x] * a[x] + b[x] * b[x]);
      sp[x] += w * (a[x] * b[x]);
    }
  }
}

LIPPMANN_MULTIVERSION void similarity_of_row(const Sums& sums, int width, const Window& window, double* __restrict result) {
  const double *a = sums.a.data(), *b = sums.b.data(), *ss = sums.squares.data(), *sp = sums.product.data();
  for (int x = 0; x < width; ++x) {
    double mu_a = 0.0, mu_b = 0.0, squares = 0.0, product = 0.0;
    for (int t = 0; t < kTaps; ++t) {
      const double w = window[t];
      mu_a += w * a[x + t];
      mu_b += w * b[x + t];
      squares += w * ss[x + t];
      product += w * sp[x + t];
    }
    const double mean_squares = mu_a * mu_a + mu_b * mu_b, mean_product = mu_a * mu_b;
    result[x] = ((2.0 * mean_product + kC1) * (2.0 * (product - mean_product) + kC2)) /
                ((mean_squares + kC1) * (squares - mean_squares + kC2));
  }
}

LIPPMANN_MULTIVERSION void contrast_structure_of_row(const Sums& sums, int width, const Window& window,
                                                     double* __restrict result) {
  const double *a = sums.a.data(), *b = sums.b.data(), *ss = sums.squares.data(), *sp = sums.product.data();
  for (int x = 0; x < width; ++x) {
    double mu_a = 0.0, mu_b = 0.0, squares = 0.0, product = 0.0;
    for (int t = 0; t < kTaps; ++t) {
      const double w = window[t];
      mu_a += w * a[x + t];
      mu_b += w * b[x + t];
      squares += w * ss[x + t];
      product += w * sp[x + t];
    }
    result[x] = (2.0 * (product - mu_a * mu_b) + kC2) / (squares - (mu_a * mu_a + mu_b * mu_b) + kC2);
  }
}

using RowFunction = void (*)(const Sums& sums, int width, const Window& window, double* result);

double mean_over_places(const SamplePlane& a, const SamplePlane& b, RowFunction of_row) {
  assert(a.width == b.width && a.height == b.height);
  const int columns = a.width - kTaps + 1, rows = a.height - kTaps + 1;
  if (columns < 1 || rows < 1) return std::numeric_limits<double>::quiet_NaN();
  const Window window = gaussian();
  const std::size_t width = static_cast<std::size_t>(a.width);
  Sums sums(width);
  std::vector<double> row(static_cast<std::size_t>(columns));
  double total = 0.0;
  for (int y = 0; y < rows; ++y) {
    sum_down(&a.samples[y * width], &b.samples[y * width], a.width, window, sums);
    of_row(sums, columns, window, row.data());
    double row_total = 0.0;
    for (const double value : row) row_total += value;
    total += row_total;
  }
  return total / (static_cast<double>(columns) * rows);
}

}  // namespace

SamplePlane luma_601(const Image8& image) {
  SamplePlane y{image.width, image.height, std::vector<double>(image.rgb.size() / 3)};
  for (std::size_t i = 0; i < y.samples.size(); ++i)
    y.samples[i] = 0.299 * image.rgb[3 * i] + 0.587 * image.rgb[3 * i + 1] + 0.114 * image.rgb[3 * i + 2];
  return y;
}

double ssim(const SamplePlane& reference, const SamplePlane& test) {
  return mean_over_places(reference, test, similarity_of_row);
}

double contrast_structure(const SamplePlane& reference, const SamplePlane& test) {
  return mean_over_places(reference, test, contrast_structure_of_row);
}

double ssim(const Image8& reference, const Image8& test) { return ssim(luma_601(reference), luma_601(test)); }

}  // namespace lippmann
