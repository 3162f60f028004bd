// A display as JSON, for reports and `lippmann displays --json`.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "lippmann/display/display.hpp"

namespace lippmann {

/// As docs/reference/displays.md names the keys of files; besides, what follows from them: views, periods, tilt, lens pitch,
/// size.
nlohmann::ordered_json display_json(const Display& display);

}  // namespace lippmann
