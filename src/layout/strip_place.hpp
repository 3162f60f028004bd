#pragma once

#include <cmath>

#include "lippmann/display/display.hpp"

namespace lippmann {

struct StripPlace {
  double lens = 0.0;    ///< index of the strip and its lens, a whole number
  double within = 0.0;  ///< position in the strip, from 0 at its left end to below 1
};

/// Position of `point` within the strips below the lenses of a sheet. `point`: in pixels (y down; the centre of the
/// first pixel is at 0.5). A point on the edge between two parts of a strip counts as in the right part, regardless of
/// rounding errors.
inline StripPlace strip_place(const LensStrips& strips, Vec2d point) {
  constexpr double kRoundingPx = 1e-6;
  const double s = point.x * strips.cosine - point.y * strips.sine;
  const double strip = (s - strips.start_px + kRoundingPx) / strips.cell_px, lens = std::floor(strip);
  return {lens, strip - lens};
}

}  // namespace lippmann
