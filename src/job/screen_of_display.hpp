// The screen of a display that was chosen by name, in its own millimetres, with what the parameters say besides.
//
// Slanted panels are shown a quilt unless --layout native asks for their own sub-pixels. Sheets and microlens arrays show what
// lies behind their lenses. The viewer stands where the display wants one, not where the scene's camera is: cells converge to
// where eyes will be. --optics single: what one eye in the middle sees of the display.
#pragma once

#include "job/params.hpp"
#include "job/screen.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

/// Throws a usage Error for what the display does not have, or decides itself (lenses).
Screen screen_of_display(const RenderParams& params, const Display& display);

}  // namespace lippmann
