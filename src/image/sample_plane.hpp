// An image of one channel in double precision, for metrics.
#pragma once

#include <cstddef>
#include <vector>

namespace lippmann {

struct SamplePlane {
  int width = 0, height = 0;
  std::vector<double> samples;

  double at(int x, int y) const { return samples[static_cast<std::size_t>(y) * width + x]; }
};

}  // namespace lippmann
