// The panel that a page plays light fields on: what its calibration comes to, so that the page's shader makes the codes that
// `interlace` (layout/interlace.hpp) makes.
//
// Calibrations are read here alone: a page sends the text of a file that was dropped on it, and gets the same numbers back.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "lippmann/display/display.hpp"
#include "lippmann/layout/interlace.hpp"
#include "view/page_field.hpp"

namespace lippmann {

struct PageDisplay {
  Display display;
  InterlaceParams interlace = {};
};

/// Throws a usage Error naming `views` where views are more than one row, of which no panel's frame is made.
void require_one_row(const PageFacts& facts);

/// Which view each sub-pixel is of (docs/guide/view.md lists the keys).
nlohmann::ordered_json phases_json(const ViewPhases& phases);

/// The same of a panel, with its name and size, and how views are mixed.
nlohmann::ordered_json page_display_json(const PageDisplay& shown);

/// The text of a visual.json that came from the page, interlaced as `otherwise` says. Throws Error naming "the calibration".
PageDisplay dropped_calibration(std::string_view text, const InterlaceParams& otherwise);

}  // namespace lippmann
