// The optics of `layout` stereo: two eyes before a screen, each with an off-axis view through the screen's rectangle.
#pragma once

#include "job/params.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

inline constexpr double kUsualScreenMm = 600.0;  ///< the width of a screen of 27 inches

/// Throws a usage Error for parameters of stereo without `layout` stereo.
void refuse_stereo_params(const RenderParams& params);

/// Two views side by side on the panel (a camera grid of 2 x 1), squeezed as the packing wants them. The screen is the
/// display's where there is one, with its viewing distance; else of square pixels, and the eyes are where the scene's camera
/// stands. Throws a usage Error for parameters of other optics, and sizes that do not divide.
Optics stereo_optics(const RenderParams& params, const FittedArray& array, const Display* display);

/// Width / height of the screen.
float stereo_window_aspect(const RenderParams& params, const Display* display);

}  // namespace lippmann
