// Optics as JSON, in the format of report.json.
//
// Lengths are in millimetres of the display frame, null means infinite. Angles are in degrees.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns JSON for the display as built: a parallax other than 1 belongs to the picture and is not written. "width" and
/// "pixel_pitch_mm" refer to the film, that is, for a slanted panel, to its sub-pixels. Also writes the derived values
/// "viewing_zone_deg" and "depth_budget_mm".
nlohmann::ordered_json optics_json(const Optics& optics);

/// Reads optics from untrusted JSON; the result passes validate(). Ignores derived values and unknown keys. "offset_mm",
/// "eye_height_mm", "cone_ends_included", "pixel_height", "pixel_offset_px" and "z_front_mm" are optional. Throws Error naming
/// `where` and the key.
Optics optics_from_json(const nlohmann::ordered_json& json, const std::string& where);

}  // namespace lippmann
