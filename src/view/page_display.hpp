// The panel on which a page plays light fields. From the panel's phases, the page's shader computes the same image as
// layout/interlace.hpp. Only this module parses calibrations; the page sends it the text of a dropped file.
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

nlohmann::ordered_json phases_json(const ViewPhases& phases);

nlohmann::ordered_json page_display_json(const PageDisplay& shown);

/// Parses a visual.json that the page sent. `otherwise` provides values that the file does not define. Throws Error naming "the
/// calibration".
PageDisplay dropped_calibration(std::string_view text, const InterlaceParams& otherwise);

}  // namespace lippmann
