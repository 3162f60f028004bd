// Based on: Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom, Fairchild, "FLIP: A difference evaluator for alternating
// images", Proc. ACM on Computer Graphics and Interactive Techniques 3(2), 2020, sections 4 and 5. The constants are those of
// the authors' program. A monitor 0.7 m wide with 3840 pixels, seen from 0.7 m, has 67 pixels per degree.
//
// 1. Convert colours to YCxCz, blur them with the eye's contrast sensitivity functions (luminance, red-green and blue-yellow),
//    and clamp them to the sRGB gamut.
// 2. Convert to CIELAB and reduce chroma in dark regions (Hunt adjustment). The colour difference is the HyAB distance to the
//    power q_c, mapped to 0 ... 1 so that p_c times the largest difference becomes p_t.
// 3. Compute the feature difference. Edges and points are detected in Y by the first and second derivative of a Gaussian. Take
//    the larger of the difference of edges and the difference of points. Divide by the square root of 2, then raise to the
//    power q_f.
// 4. FLIP of a pixel is (colour difference) ^ (1 - feature difference).
//
//   letter | here             | value
//   q_c    | kColorPower      | 0.7
//   p_c    | kKneeIn          | 0.4
//   p_t    | kKneeOut         | 0.95
//   w      | kFeatureWidthDeg | 0.082 degrees
//   q_f    | kFeaturePower    | 0.5
//
// All filters are separable; the blue-yellow filter is a sum of two separable Gaussians. At the borders, edge pixels are
// repeated.
#include "image/flip.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "image/sample_plane.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann {
namespace {

constexpr double kPixelsPerDegree = 0.7 * 3840.0 / 0.7 * std::numbers::pi / 180.0;
constexpr double kColorPower = 0.7, kKneeIn = 0.4, kKneeOut = 0.95, kFeatureWidthDeg = 0.082, kFeaturePower = 0.5;

using Color = std::array<double, 3>;
using Kernel = std::vector<double>;  // an odd number of taps, the middle one at the filtered pixel

constexpr std::array<Color, 3> kXyzFromRgb{{{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                                            {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                                            {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};
constexpr std::array<Color, 3> kRgbFromXyz{{{3.241003232976358, -1.537398969488785, -0.498615881996363},
                                            {-0.969224252202516, 1.875929983695176, 0.041554226340085},
                                            {0.055639419851975, -0.204011206123910, 1.057148977187533}}};

Color transformed(const std::array<Color, 3>& matrix, const Color& v) {
  Color result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = matrix[i][0] * v[0] + matrix[i][1] * v[1] + matrix[i][2] * v[2];
  return result;
}

Color white() { return transformed(kXyzFromRgb, {1.0, 1.0, 1.0}); }

Color ycxcz_of(const Color& xyz) { return {116.0 * xyz[1] - 16.0, 500.0 * (xyz[0] - xyz[1]), 200.0 * (xyz[1] - xyz[2])}; }

Color xyz_of(const Color& ycxcz) {
  const double y = (ycxcz[0] + 16.0) / 116.0;
  return {y + ycxcz[1] / 500.0, y, y - ycxcz[2] / 200.0};
}

/// Converts linear light to CIELAB with Hunt's adjustment: chroma times L / 100.
Color hunt_lab_of(const Color& rgb) {
  constexpr double kDelta = 6.0 / 29.0;
  const Color xyz = transformed(kXyzFromRgb, rgb), reference = white();
  Color f{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double t = xyz[i] / reference[i];
    f[i] = t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
  }
  const double lightness = 116.0 * f[1] - 16.0;
  return {lightness, 0.01 * lightness * 500.0 * (f[0] - f[1]), 0.01 * lightness * 200.0 * (f[1] - f[2])};
}

double hyab(const Color& a, const Color& b) { return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]); }

void scale_to_sum_one(Kernel& kernel) {
  double sum = 0.0;
  for (const double tap : kernel) sum += tap;
  for (double& tap : kernel) tap /= sum;
}

Kernel gaussian(int radius, double inverse_twice_variance) {
  Kernel kernel;
  for (int x = -radius; x <= radius; ++x) kernel.push_back(std::exp(-inverse_twice_variance * x * x));
  return kernel;
}

void balance(Kernel& kernel) {
  double positive = 0.0, negative = 0.0;
  for (const double tap : kernel) (tap > 0.0 ? positive : negative) += tap;
  for (double& tap : kernel) tap /= tap > 0.0 ? positive : -negative;
}

void filter_line(const double* from, double* to, int count, std::ptrdiff_t stride, const Kernel& kernel) {
  const int radius = static_cast<int>(kernel.size() / 2);
  for (int i = 0; i < count; ++i) {
    double sum = 0.0;
    for (int t = -radius; t <= radius; ++t)
      sum += kernel[static_cast<std::size_t>(t + radius)] * from[stride * std::clamp(i + t, 0, count - 1)];
    to[stride * i] = sum;
  }
}

SamplePlane filtered(const SamplePlane& plane, const Kernel& across, const Kernel& down) {
  SamplePlane rows = plane, result = plane;
  for (int y = 0; y < plane.height; ++y) {
    const std::size_t first = static_cast<std::size_t>(y) * plane.width;
    filter_line(&plane.samples[first], &rows.samples[first], plane.width, 1, across);
  }
  const int radius = static_cast<int>(down.size() / 2);
  for (int y = 0; y < plane.height; ++y) {
    double* to = &result.samples[static_cast<std::size_t>(y) * plane.width];
    std::fill_n(to, plane.width, 0.0);
    for (int t = -radius; t <= radius; ++t) {
      const double tap = down[static_cast<std::size_t>(t + radius)];
      const double* from = &rows.samples[static_cast<std::size_t>(std::clamp(y + t, 0, plane.height - 1)) * plane.width];
      for (int x = 0; x < plane.width; ++x) to[x] += tap * from[x];
    }
  }
  return result;
}

/// A Gaussian term a sqrt(pi / b) exp(-pi^2 r^2 / b) of a contrast sensitivity function, with r in degrees.
struct Sensitivity {
  double a, b;
};

constexpr double kWidestB = 0.04;

/// Blurs by a sum of Gaussians, which is normalised as a whole.
SamplePlane blurred(const SamplePlane& plane, const std::vector<Sensitivity>& terms) {
  using std::numbers::pi;
  const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(kWidestB / (2.0 * pi * pi)) * kPixelsPerDegree));
  SamplePlane sum{plane.width, plane.height, std::vector<double>(plane.samples.size())};
  double weights = 0.0;
  for (const auto& [a, b] : terms) {
    Kernel kernel = gaussian(radius, pi * pi / (b * kPixelsPerDegree * kPixelsPerDegree));
    double taps = 0.0;
    for (const double tap : kernel) taps += tap;
    const double weight = a * std::sqrt(pi / b) * taps * taps;
    scale_to_sum_one(kernel);
    const SamplePlane part = filtered(plane, kernel, kernel);
    for (std::size_t i = 0; i < sum.samples.size(); ++i) sum.samples[i] += weight * part.samples[i];
    weights += weight;
  }
  for (double& sample : sum.samples) sample /= weights;
  return sum;
}

using Opponents = std::array<SamplePlane, 3>;

Opponents opponents_of(const Image8& image) {
  std::array<double, 256> linear{};
  for (std::size_t code = 0; code < linear.size(); ++code) linear[code] = linear_from_srgb(static_cast<double>(code) / 255.0);
  const Color reference = white();
  Opponents planes;
  for (SamplePlane& plane : planes) plane = {image.width, image.height, std::vector<double>(image.rgb.size() / 3)};
  for (std::size_t i = 0; i < planes[0].samples.size(); ++i) {
    const unsigned char* code = &image.rgb[3 * i];
    Color xyz = transformed(kXyzFromRgb, {linear[code[0]], linear[code[1]], linear[code[2]]});
    for (std::size_t c = 0; c < 3; ++c) xyz[c] /= reference[c];
    const Color ycxcz = ycxcz_of(xyz);
    for (std::size_t c = 0; c < 3; ++c) planes[c].samples[i] = ycxcz[c];
  }
  return planes;
}

/// Removes details that the eye does not resolve. Returns Hunt-adjusted CIELAB.
std::vector<Color> seen_colors(const Opponents& opponents) {
  const Opponents blurry{blurred(opponents[0], {{1.0, 0.0047}}), blurred(opponents[1], {{1.0, 0.0053}}),
                         blurred(opponents[2], {{34.1, 0.04}, {13.5, 0.025}})};
  const Color reference = white();
  std::vector<Color> colors(opponents[0].samples.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    Color xyz = xyz_of({blurry[0].samples[i], blurry[1].samples[i], blurry[2].samples[i]});
    for (std::size_t c = 0; c < 3; ++c) xyz[c] *= reference[c];
    Color rgb = transformed(kRgbFromXyz, xyz);
    for (double& value : rgb) value = std::clamp(value, 0.0, 1.0);
    colors[i] = hunt_lab_of(rgb);
  }
  return colors;
}

double color_difference(double distance, double largest) {
  const double power = std::pow(distance, kColorPower), knee = kKneeIn * largest;
  if (power < knee) return kKneeOut / knee * power;
  return kKneeOut + (power - knee) / (largest - knee) * (1.0 - kKneeOut);
}

struct Features {
  std::vector<double> edges, points;
};

std::vector<double> magnitudes(const SamplePlane& luminance, const Kernel& derivative, const Kernel& smooth) {
  SamplePlane across = filtered(luminance, derivative, smooth);
  const SamplePlane down = filtered(luminance, smooth, derivative);
  for (std::size_t i = 0; i < across.samples.size(); ++i) across.samples[i] = std::hypot(across.samples[i], down.samples[i]);
  return std::move(across.samples);
}

Features features_of(SamplePlane luminance) {
  for (double& sample : luminance.samples) sample = (sample + 16.0) / 116.0;
  const double sigma = 0.5 * kFeatureWidthDeg * kPixelsPerDegree;
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  Kernel smooth = gaussian(radius, 1.0 / (2.0 * sigma * sigma)), first = smooth, second = smooth;
  for (int x = -radius; x <= radius; ++x) {
    const std::size_t i = static_cast<std::size_t>(x + radius);
    first[i] *= -x;
    second[i] *= x * x / (sigma * sigma) - 1.0;
  }
  balance(first);
  balance(second);
  scale_to_sum_one(smooth);
  return {magnitudes(luminance, first, smooth), magnitudes(luminance, second, smooth)};
}

}  // namespace

double flip(const Image8& reference, const Image8& test) {
  assert(reference.width == test.width && reference.height == test.height);
  const Opponents a = opponents_of(reference), b = opponents_of(test);
  const std::vector<Color> color_a = seen_colors(a), color_b = seen_colors(b);
  const Features feature_a = features_of(a[0]), feature_b = features_of(b[0]);
  const double largest = std::pow(hyab(hunt_lab_of({0.0, 1.0, 0.0}), hunt_lab_of({0.0, 0.0, 1.0})), kColorPower);
  double sum = 0.0;
  for (std::size_t i = 0; i < color_a.size(); ++i) {
    const double color = color_difference(hyab(color_a[i], color_b[i]), largest);
    const double feature =
        std::max(std::abs(feature_a.edges[i] - feature_b.edges[i]), std::abs(feature_a.points[i] - feature_b.points[i]));
    sum += std::pow(color, 1.0 - std::pow(feature / std::numbers::sqrt2, kFeaturePower));
  }
  return sum / static_cast<double>(color_a.size());
}

}  // namespace lippmann
