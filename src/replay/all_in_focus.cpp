#include "lippmann/replay/all_in_focus.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "lippmann/optics/viewing.hpp"

namespace lippmann {
namespace {

constexpr double kWindowRadius = 1.5;  ///< half width of the averaging window, in distances between lenses
constexpr float kNoRays = 1e6f;        ///< value for pixels without rays; finite, so that sums stay finite

/// Replaces each of `count` samples by the mean of the samples up to `radius` samples away. Samples are `stride` floats apart.
/// `upto`: memory for the sums.
void average_windows(float* line, int count, int stride, int radius, std::vector<double>& upto) {
  upto.assign(1, 0.0);
  for (int i = 0; i < count; ++i) upto.push_back(upto.back() + std::min(line[i * stride], kNoRays));
  for (int i = 0; i < count; ++i) {
    const int first = std::max(0, i - radius), end = std::min(count, i + radius + 1);
    const double sum = upto[static_cast<std::size_t>(end)] - upto[static_cast<std::size_t>(first)];
    line[i * stride] = static_cast<float>(sum / (end - first));
  }
}

}  // namespace

AllInFocus::AllInFocus(const Optics& optics, Vec2i size)
    : picture_(size.x, size.y, 3), depth_(size.x, size.y, 1), least_(size.x, size.y, 1) {
  // The averaging window is square in mm. Its size follows from the larger one of the lens spacings across and down.
  const Vec2d spacing = sample_spacing_mm(optics), pixel = display_window(optics).size / Vec2d(size);
  const Vec2d pixels = kWindowRadius * std::max(spacing.x, spacing.y) / pixel;
  radius_ = Vec2i(glm::clamp(glm::round(pixels), Vec2d(1.0), Vec2d(size)));
  std::fill(least_.data.begin(), least_.data.end(), kInfinity);
}

void AllInFocus::add(const Image& refocused, const Image& disagreement, double z_mm) {
  Image mean = disagreement;
  std::vector<double> upto;
  for (int y = 0; y < mean.height; ++y) average_windows(mean.pixel(0, y), mean.width, 1, radius_.x, upto);
  for (int x = 0; x < mean.width; ++x) average_windows(mean.pixel(x, 0), mean.height, mean.width, radius_.y, upto);
  for (std::size_t i = 0; i < mean.data.size(); ++i) {
    if (!(mean.data[i] < least_.data[i])) continue;
    least_.data[i] = mean.data[i];
    depth_.data[i] = static_cast<float>(z_mm);
    std::copy_n(&refocused.data[3 * i], 3, &picture_.data[3 * i]);
  }
}

}  // namespace lippmann
