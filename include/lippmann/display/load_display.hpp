// Loads displays by name or from files: built-in presets, a user's TOML, a device's calibration JSON.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lippmann/display/display.hpp"

namespace lippmann {

/// Loads a display. preset_or_path: the name of a preset ("looking-glass-portrait", or without "looking-glass-"); a .toml file
/// of a display; a .json calibration ("visual.json"), which takes missing values (quilt, cone, video) from the preset of its
/// serial number; or a lenticular sheet in one line, "lpi=60.12 dpi=600 paper=A5" (docs/guide/displays.md). Throws Error naming
/// the file and key; for an unknown name, it suggests the nearest.
Display load_display(const std::string& preset_or_path);

/// Returns whether `display` is a path, and not the name of a preset or a sheet in one line.
bool is_display_file(const std::string& display);

/// Returns all presets, sorted by name.
std::vector<Display> display_presets();

/// Reads a display from TOML text. where: file name for messages. The optics of the result pass validate().
Display display_from_toml(std::string_view text, const std::string& where);
Display display_from_calibration(std::string_view text, const std::string& where);

}  // namespace lippmann
