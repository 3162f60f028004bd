// A lenticular sheet on a print, in one line: "lpi=60.12 dpi=600 paper=A5". Private to this part.
//
//   lpi, lenses-per-mm, pitch-mm  one of them: the pitch of the lenses. Without viewing-distance the print gets the same pitch
//   visual-lpi         in their place: the pitch of the print that a pitch test gave at viewing-distance
//   dpi                pixels per inch of the print
//   paper              A0 ... A8, letter, legal, tabloid, or a size: 148x210mm, 5x7in, 3593x2783px; landscape turns it
//   viewing-distance   mm, from the eye to the lenses; default: where the height of the print spans 14 degrees
//   view-angle         degrees, of the viewing zone; default 50
//   slant              degrees, of the lenses from the vertical; default 0
//   phase              where a lens begins, pixels from the left edge; default 0
//
// Lenses of pitch p lie a gap g before the print. Rays from the eye, at the distance D from the lenses, through two
// neighbouring lens centres meet the print, at D + g, p (D + g) / D apart: that is the pitch of the print, above the lenses'
// own.
#pragma once

#include <string>

#include "lippmann/display/display.hpp"

namespace lippmann {

/// Whether a text is such a line, and neither the name of a preset nor a file.
bool is_sheet_line(const std::string& text);

/// Throws a usage Error naming the key.
Display display_from_line(const std::string& line);

}  // namespace lippmann
