#pragma once

#include <cmath>
#include <vector>

#include "trace/small_scene.hpp"

namespace lippmann::test {

struct Edge {
  double place_px, variance_px2;
};

/// Returns the mean position, relative to pixel `first`, and the variance of the step from light to dark in the
/// picture's second row.
inline Edge edge_in(const Picture& picture, int first, int width) {
  std::vector<double> steps;
  for (int x = first + 1; x < first + width; ++x) steps.push_back(picture.at(x - 1, 1).x - picture.at(x, 1).x);
  Edge edge{0.0, 0.0};
  for (std::size_t i = 0; i < steps.size(); ++i) edge.place_px += steps[i] * static_cast<double>(i + 1);
  for (std::size_t i = 0; i < steps.size(); ++i)
    edge.variance_px2 += steps[i] * std::pow(static_cast<double>(i + 1) - edge.place_px, 2.0);
  return edge;
}

}  // namespace lippmann::test
