// Bleed, marks and one-inch proofs of prints. The marks are in a white margin of 10 mm around the bleed: crop lines at
// the corners, a target in the middle of each side, and a text with the pitch and the resolution. Sheets also have
// bands that are black below the middle third of each lens: an aligned sheet shows them completely black from the
// middle of the viewing zone.
#pragma once

#include "lippmann/layout/display_picture.hpp"

namespace lippmann {

/// Crops a print to a proof and adds marks, as `finish` requests. `display` must be the result of with_bleed() for
/// finish.bleed_mm, and `bled` the picture for this display. Throws a usage Error naming `proof` if the print is not larger
/// than an inch, and Error if the result with marks is too large.
Picture finished(Picture bled, const Display& display, const PrintFinish& finish);

}  // namespace lippmann
