// Bleed and marks around a print: bleed that is cut off, marks outside it, and proofs of one inch. Private to this part.
//
// The marks stand in a white margin of 10 mm around the bleed: lines at the corners, where the print is cut; a target in the
// middle of each side; the pitch and the resolution; and for sheets, above and below, a band that is black below the middle
// third of each lens, so that it is black all over from the middle of the viewing zone once the sheet lies straight.
#pragma once

#include "lippmann/layout/display_picture.hpp"

namespace lippmann {

/// `bled`: the picture of with_bleed(display, finish.bleed_mm), which `display` is. Throws a usage Error naming
/// `proof` for prints that are no larger than an inch, and Error for what is too large with its marks.
Picture finished(Picture bled, const Display& display, const PrintFinish& finish);

}  // namespace lippmann
