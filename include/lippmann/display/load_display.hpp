// Displays by name or from files: presets that are part of the program, a user's own TOML, a device's calibration JSON.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lippmann/display/display.hpp"

namespace lippmann {

/// The name of a preset ("looking-glass-portrait", or without "looking-glass-"), or a path: .toml, a display of one's own;
/// .json, a calibration ("visual.json"), which takes what it lacks (quilt, cone, video) from the preset of its serial number;
/// or a lenticular sheet in one line, "lpi=60.12 dpi=600 paper=A5" (docs/guide/displays.md). Throws Error naming the file and
/// key, or, of an unknown name, the nearest.
Display load_display(const std::string& preset_or_path);

/// Whether it is a path: neither the name of a preset nor a sheet in one line.
bool is_display_file(const std::string& display);

/// All presets, by name.
std::vector<Display> display_presets();

/// The same of a text; `where`: its file, for messages. What comes back makes optics that pass validate().
Display display_from_toml(std::string_view text, const std::string& where);
Display display_from_calibration(std::string_view text, const std::string& where);

}  // namespace lippmann
