// Converts the tables of display files to displays. Private to this part.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lippmann/display/display.hpp"

namespace lippmann {

/// Returns a complete display. json: the tables that docs/reference/displays.md describes for TOML files. Throws Error naming
/// `where` and the key.
Display display_from_tables(const nlohmann::ordered_json& json, const std::string& where);

/// Returns `base` changed by the values of a calibration's JSON. Pitch, slope and center are required. Throws Error as
/// display_from_tables() does.
Display display_from_visual(const nlohmann::ordered_json& json, const std::string& where, Display base);

/// Throws Error naming `where` if the display's pixels have no rays.
void check_display(const Display& display, const std::string& where);

}  // namespace lippmann
