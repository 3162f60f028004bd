// Reads a one-line description of a lenticular sheet on a print: "lpi=60.12 dpi=600 paper=A5".
//
// One of the first four keys is required:
//   lpi                lenses per inch; without viewing-distance, the print has the same pitch as the lenses
//   lenses-per-mm      like lpi, in lenses per mm
//   pitch-mm           like lpi, as the pitch of the lenses in mm
//   visual-lpi         strips of the print per inch, from a pitch test at viewing-distance
//   dpi                pixels per inch of the print
//   paper              A0 ... A8, letter, legal, tabloid, or a size: 148x210mm, 5x7in, 3593x2783px
//   landscape          makes the longer side of the paper horizontal
//   viewing-distance   distance from the eye to the lenses in mm; default: where the print's height spans 14 degrees
//   view-angle         full angle of the viewing zone, in degrees; default 50
//   slant              angle between the lenses and the vertical, in degrees; default 0
//   phase              left edge of a lens, in pixels from the left edge of the print; default 0
//
// The lenses have the pitch p and are a gap g in front of the print. The eye is at distance D from the lenses. Rays from the
// eye through two neighbouring lens centres meet the print at a distance of p (D + g) / D. This is the pitch of the print.
#pragma once

#include <string>

#include "lippmann/display/display.hpp"

namespace lippmann {

bool is_sheet_line(const std::string& text);

/// Reads a one-line description of a sheet. Throws a usage Error naming the key.
Display display_from_line(const std::string& line);

}  // namespace lippmann
