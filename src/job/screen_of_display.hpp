// The screen of a display that is chosen by name. Lengths are in millimetres on the display. Slanted panels show a
// quilt, or with --layout native an interlaced image of their sub-pixels. The viewer is at the display's viewing
// distance and not at the scene's camera, so that the viewer's eyes see one view through all lenses. --optics single
// renders the view of one eye in front of the middle of the display.
#pragma once

#include "job/params.hpp"
#include "job/screen.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

/// Throws a usage Error for parameters that the display does not support or defines itself, such as lenses.
Screen screen_of_display(const RenderParams& params, const Display& display);

}  // namespace lippmann
