// The view of every sub-pixel of a calibrated panel, for players that interlace views for the panel.
#pragma once

#include <optional>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Parameters as in SlantedPanel. For a sub-pixel at (x, y), from 0 to 1 across and up the panel, let p = (x + y tilt) periods
/// - center. If `inverted` is set, the sub-pixel shows the view 1 - fract(p) of the view cone, else fract(p).
struct ViewPhases {
  double periods = 0.0, tilt = 0.0, center = 0.0;
  bool inverted = false;
  SubPixelOffsets sub_pixels{};
};

/// Returns the phases of a calibrated slanted panel, or nothing for other optics. `optics` must pass validate().
std::optional<ViewPhases> view_phases(const Optics& optics);

}  // namespace lippmann
