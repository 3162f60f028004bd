#include "replay/taps.hpp"

#include <cmath>
#include <numbers>

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

Taps gaussian_taps(double position_px, double sigma_px) {
  Taps taps;
  const int first = static_cast<int>(std::floor(position_px - 4.0 * sigma_px));
  const int last = static_cast<int>(std::floor(position_px + 4.0 * sigma_px));
  const double scale = std::numbers::sqrt2 / 2.0 / sigma_px;
  double below = std::erf((first - position_px) * scale);
  for (int i = first; i <= last; ++i) {
    const double upto = std::erf((i + 1 - position_px) * scale);
    taps.add(i, 0.5 * (upto - below));
    below = upto;
  }
  return taps;
}

}  // namespace lippmann
