#include "lippmann/replay/taps.hpp"

#include <cmath>

namespace lippmann {

Taps taps_at(double position_px, SampleFilter filter) {
  Taps taps;
  if (filter == SampleFilter::kNearest) {
    taps.add(static_cast<int>(std::floor(position_px)), 1.0);
    return taps;
  }
  const double first = std::floor(position_px - 0.5), share = position_px - 0.5 - first;
  taps.add(static_cast<int>(first), 1.0 - share);
  taps.add(static_cast<int>(first) + 1, share);
  return taps;
}

}  // namespace lippmann
