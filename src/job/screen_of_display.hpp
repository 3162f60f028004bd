// The screen of a display chosen by name, in its own millimetres, modified by the parameters.
//
// Slanted panels show a quilt, or their own sub-pixels with --layout native. Sheets and microlens arrays show the image behind
// their lenses. The viewer is at the display's viewing distance instead of the scene's camera, so that cells converge at the
// viewer's eyes. --optics single renders what one eye in the middle sees of the display.
#pragma once

#include "job/params.hpp"
#include "job/screen.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

/// Returns the screen. Throws a usage Error for parameters that the display does not support or defines itself, such as lenses.
Screen screen_of_display(const RenderParams& params, const Display& display);

}  // namespace lippmann
