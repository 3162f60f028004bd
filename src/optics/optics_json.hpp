// Converts optics to and from JSON, in the format of report.json.
//
// Lengths are in millimetres of the display frame; null means infinity. Angles are in degrees.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns JSON that describes the physical display, without the parallax factor. "width" and "pixel_pitch_mm" refer to the
/// film; for a slanted panel, they refer to sub-pixels. "viewing_zone_deg" and "depth_budget_mm" are derived values.
nlohmann::ordered_json optics_json(const Optics& optics);

/// Returns optics from untrusted JSON. The result passes validate(). Derived values and unknown keys are ignored. "offset_mm",
/// "eye_height_mm", "cone_ends_included", "pixel_height", "pixel_offset_px" and "z_front_mm" are optional. Throws Error naming
/// `where` and the key.
Optics optics_from_json(const nlohmann::ordered_json& json, const std::string& where);

}  // namespace lippmann
