// The screen of `layout` stereo: two eyes in front of a screen, each with an off-axis view through the screen's
// rectangle.
#pragma once

#include "job/params.hpp"
#include "job/screen.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

inline constexpr double kDefaultScreenMm = 600.0;  ///< width of a 27-inch screen

/// Throws a usage Error if any parameter is given that only stereo pictures use.
void refuse_stereo_params(const OpticsParams& optics);

/// Returns a screen with two views side by side (a camera grid of 2 x 1), squeezed as the packing requires. A display
/// defines the size and the viewing distance. Without a display, pixels are square and the eyes are at the scene's
/// camera. Throws a usage Error for parameters of other optics, and for sizes that cannot be divided into two views.
Screen screen_for_stereo(const RenderParams& params, const Display* display);

}  // namespace lippmann
