// The panel on which a page plays light fields. PageDisplay includes the phases with which the page's shader computes the same
// image as `interlace` (layout/interlace.hpp).
//
// Only this module parses calibrations: the page sends the text of a file that was dropped on it, and receives the phases.
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

/// Throws a usage Error naming `views` if the views have more than one row, because panels cannot interlace them.
void require_one_row(const PageFacts& facts);

/// Describes which view each sub-pixel shows. web/README.md lists the keys.
nlohmann::ordered_json phases_json(const ViewPhases& phases);

/// Describes a panel: its phases, name, size and view filter.
nlohmann::ordered_json page_display_json(const PageDisplay& shown);

/// Parses the text of a visual.json that the page sent. otherwise: how the panel interlaces views, which the file does not
/// define. Throws Error naming "the calibration".
PageDisplay dropped_calibration(std::string_view text, const InterlaceParams& otherwise);

}  // namespace lippmann
