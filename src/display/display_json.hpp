// Writes a display as JSON, for reports and `lippmann displays --json`.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "lippmann/display/display.hpp"

namespace lippmann {

/// Returns JSON with the keys of docs/reference/displays.md and with derived values: views, periods, tilt, lens pitch, size.
nlohmann::ordered_json display_json(const Display& display);

}  // namespace lippmann
