// Bleed, marks and one-inch proofs of prints. Private to src/layout.
//
// The marks are in a white margin of 10 mm around the bleed: crop lines at the corners; a target in the middle of each side; a
// text with the pitch and the resolution; and for sheets, above and below, a band that is black below the middle third of each
// lens. When the sheet is aligned, the band looks completely black from the middle of the viewing zone.
#pragma once

#include "lippmann/layout/display_picture.hpp"

namespace lippmann {

/// Returns the finished print. `display` must be the result of with_bleed() for finish.bleed_mm, and `bled` the picture for
/// this display. Throws a usage Error naming `proof` if the print is not larger than an inch, and Error if the result with
/// marks is too large.
Picture finished(Picture bled, const Display& display, const PrintFinish& finish);

}  // namespace lippmann
