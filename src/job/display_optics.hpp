// The optics of a display that was chosen by name, in its own millimetres, with what the parameters say besides.
//
// Slanted panels are shown a quilt unless --layout native asks for their own sub-pixels. Sheets and microlens arrays show what
// lies behind their lenses. The viewer stands where the display wants one, not where the scene's camera is: cells converge to
// where eyes will be. --optics single: what one eye in the middle sees of the display.
#pragma once

#include <memory>

#include "job/params.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// The display that the parameters name; none if they name none. Throws Error naming the file or the nearest preset.
std::unique_ptr<const Display> wanted_display(const RenderParams& params);

/// Throws a usage Error for what the display does not have, or decides itself (lenses).
Optics display_optics(const RenderParams& params, const Display& display);

}  // namespace lippmann
