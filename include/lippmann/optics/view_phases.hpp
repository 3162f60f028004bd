// The view of every sub-pixel of a calibrated panel, for players that interlace views for it.
#pragma once

#include <optional>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Parameters as in SlantedPanel: a sub-pixel at (x, y), from 0 to 1 across the panel and up it, shows the view 1 - fract((x +
/// y tilt) periods - center) of the view cone, or fract(...) if not `inverted`.
struct ViewPhases {
  double periods = 0.0, tilt = 0.0, center = 0.0;
  bool inverted = false;
  SubPixelOffsets sub_pixels{};
};

/// Returns the phases of a calibrated slanted panel; none for other optics. `optics` must pass validate().
std::optional<ViewPhases> view_phases(const Optics& optics);

}  // namespace lippmann
