// The panel that a page plays light fields on, with the phases that let the page's shader reproduce `interlace`
// (layout/interlace.hpp).
//
// Only this module parses calibrations: the page sends the text of a dropped file and receives the phases.
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

/// Throws a usage Error naming `views` if the views have more than one row, which panels cannot interlace.
void require_one_row(const PageFacts& facts);

/// Returns which view each sub-pixel shows. web/README.md lists the keys.
nlohmann::ordered_json phases_json(const ViewPhases& phases);

/// Returns the phases of a panel with its name, its size and the view filter.
nlohmann::ordered_json page_display_json(const PageDisplay& shown);

/// Parses the text of a visual.json sent by the page. otherwise: how views are interlaced. Throws Error naming "the
/// calibration".
PageDisplay dropped_calibration(std::string_view text, const InterlaceParams& otherwise);

}  // namespace lippmann
