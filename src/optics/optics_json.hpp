// Optics as JSON, and back: what report.json says of the array that its pictures were rendered for.
//
// Lengths are in millimetres of the display frame, null: infinite. Angles are in degrees.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Describes the display as built: a parallax other than 1 is the picture's, and not written.
/// "width" and "pixel_pitch_mm" are those of the film: of a slanted panel, its sub-pixels.
/// Also says what follows from the rest: "viewing_zone_deg" and "depth_budget_mm".
nlohmann::ordered_json optics_json(const Optics& optics);

/// The inverse, of JSON from anywhere: what comes back passes validate(). What follows from the rest is not read, nor are keys
/// that nobody knows; "offset_mm", "eye_height_mm", "cone_ends_included", "pixel_height", "pixel_offset_px" and "z_front_mm"
/// may be missing. Throws Error naming `where` and the key.
Optics optics_from_json(const nlohmann::ordered_json& json, const std::string& where);

}  // namespace lippmann
