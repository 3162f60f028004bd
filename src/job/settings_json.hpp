// The parameters of a render as JSON: "settings" of report.json.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "job/params.hpp"

namespace lippmann {

/// Every parameter but the scene by its name, in the order of --help; null: it is not given and follows from others.
nlohmann::ordered_json settings_json(const RenderParams& params);

}  // namespace lippmann
