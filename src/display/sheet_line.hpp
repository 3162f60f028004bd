// Reads a lenticular sheet on a print from one line: "lpi=60.12 dpi=600 paper=A5". Private to this part.
//
//   lpi, lenses-per-mm, pitch-mm  one of them: the pitch of the lenses. Without viewing-distance the print gets the same pitch
//   visual-lpi         instead of these: the pitch of the print, from a pitch test at viewing-distance
//   dpi                pixels per inch of the print
//   paper              A0 ... A8, letter, legal, tabloid, or a size: 148x210mm, 5x7in, 3593x2783px; landscape turns it
//   viewing-distance   mm, from the eye to the lenses; default: the distance at which the print's height spans 14 degrees
//   view-angle         degrees, of the viewing zone; default 50
//   slant              degrees, of the lenses from the vertical; default 0
//   phase              left edge of a lens, pixels from the left edge of the print; default 0
//
// Lenses of pitch p are a gap g in front of the print, and the eye is at the distance D from the lenses. Rays from the eye
// through two neighbouring lens centres meet the print, at D + g, p (D + g) / D apart. This is the pitch of the print, which is
// larger than the pitch of the lenses.
#pragma once

#include <string>

#include "lippmann/display/display.hpp"

namespace lippmann {

/// Returns whether a text is such a line, and not the name of a preset or file.
bool is_sheet_line(const std::string& text);

/// Reads a line. Throws a usage Error naming the key.
Display display_from_line(const std::string& line);

}  // namespace lippmann
