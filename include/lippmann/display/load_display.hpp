// Loads displays from built-in presets, TOML files of users, or calibration files (JSON) of devices.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lippmann/display/display.hpp"

namespace lippmann {

/// Loads a display. `preset_or_path` is one of:
/// - the name of a preset ("looking-glass-portrait"; "looking-glass-" may be left out)
/// - a .toml file that describes a display
/// - a .json calibration ("visual.json"); the preset for its serial number supplies the missing values (quilt, cone, video)
/// - a one-line description of a lenticular sheet, "lpi=60.12 dpi=600 paper=A5" (docs/guide/displays.md)
/// Throws Error naming the file and key. For an unknown name, the message suggests the most similar one.
Display load_display(const std::string& preset_or_path);

/// Returns whether `display` is a path, and neither the name of a preset nor a one-line description of a sheet.
bool is_display_file(const std::string& display);

/// Returns all built-in displays.
std::vector<Display> display_presets();

/// Read a display from the text of a TOML file or of a calibration. `where` is the file name for error messages. The optics of
/// the result pass validate().
Display display_from_toml(std::string_view text, const std::string& where);
Display display_from_calibration(std::string_view text, const std::string& where);

}  // namespace lippmann
