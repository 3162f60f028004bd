// Which view every sub-pixel of a calibrated panel belongs to: what a player needs that interlaces views for it.
#pragma once

#include <optional>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// As SlantedPanel has them: a sub-pixel at (x, y), from 0 to 1 across the panel and up it, shows the view
/// 1 - fract((x + y tilt) periods - center) of the view cone, or without the 1 - where that is not inverted.
struct ViewPhases {
  double periods, tilt, center;
  bool inverted;
  SubPixelOffsets sub_pixels;
};

/// None where no calibration says it. `optics` must pass validate().
std::optional<ViewPhases> view_phases(const Optics& optics);

}  // namespace lippmann
