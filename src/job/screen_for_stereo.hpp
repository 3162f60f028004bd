// The screen of `layout` stereo: two eyes before a screen, each with an off-axis view through the screen's rectangle.
#pragma once

#include "job/params.hpp"
#include "job/screen.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

inline constexpr double kUsualScreenMm = 600.0;  ///< the width of a screen of 27 inches

/// Throws a usage Error for parameters that only stereo pictures have.
void refuse_stereo_params(const OpticsParams& optics);

/// Two views side by side on the panel (a camera grid of 2 x 1), squeezed as the packing wants them. The screen is the
/// display's where there is one, with its viewing distance; else of square pixels, and the eyes are where the scene's camera
/// stands. Throws a usage Error for parameters of other optics, and sizes that do not divide.
Screen screen_for_stereo(const RenderParams& params, const Display* display);

}  // namespace lippmann
