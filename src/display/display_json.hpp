#pragma once

#include <nlohmann/json_fwd.hpp>

#include "lippmann/display/display.hpp"

namespace lippmann {

nlohmann::ordered_json display_json(const Display& display);

}  // namespace lippmann
