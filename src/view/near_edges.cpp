#include "view/near_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lippmann {
namespace {

constexpr double kVisiblePixels = 0.5;

double jump_along(const ViewAxis& axis, double pixel_mm) {
  if (axis.count < 2 || axis.step == 0.0) return std::numeric_limits<double>::infinity();
  const double middle = 0.5 * (axis.count - 1);
  return kVisiblePixels * pixel_mm / std::abs(axis.slope(middle + 0.5) - axis.slope(middle - 0.5));
}

std::vector<float> greatest_of_three(const std::vector<float>& values, std::size_t count, std::size_t stride) {
  std::vector<float> greatest = values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t place = i / stride % count;
    const auto take = [&](std::size_t neighbour) {
      if (std::isfinite(values[neighbour]) && !(greatest[i] >= values[neighbour])) greatest[i] = values[neighbour];
    };
    if (place > 0) take(i - stride);
    if (place + 1 < count) take(i + stride);
  }
  return greatest;
}

}  // namespace

double visible_jump_mm(const PageFacts& facts, Vec2i view_size) {
  const Vec2d pixel = facts.window.size / Vec2d(view_size);
  return std::min(jump_along(facts.axes.across, pixel.x), jump_along(facts.axes.up, pixel.y));
}

void spread_near_disparities(Image& disparities, Vec2i view_size, double jump_mm) {
  const auto [width, height] = std::pair(static_cast<std::size_t>(view_size.x), static_cast<std::size_t>(view_size.y));
  const auto stride = static_cast<std::size_t>(disparities.width);
  const std::vector<float> nearest = greatest_of_three(greatest_of_three(disparities.data, width, 1), height, stride);
  for (std::size_t i = 0; i < nearest.size(); ++i)
    if (disparities.data[i] < nearest[i] - jump_mm) disparities.data[i] = nearest[i];
}

}  // namespace lippmann
