#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lippmann/display/display.hpp"

namespace lippmann {

/// Returns a complete display. `json` has the tables of a TOML file (docs/reference/displays.md). Throws Error naming `where`
/// and the key.
Display display_from_tables(const nlohmann::ordered_json& json, const std::string& where);

/// Returns `base` with the values of a calibration (JSON). Pitch, slope and center are required. Throws Error as
/// display_from_tables() does.
Display display_from_visual(const nlohmann::ordered_json& json, const std::string& where, Display base);

void check_display(const Display& display, const std::string& where);

}  // namespace lippmann
