#pragma once

#include <nlohmann/json_fwd.hpp>

#include "job/params.hpp"

namespace lippmann {

/// Returns every parameter except the scene, in the order of --help, for "settings" in report.json. A parameter that is
/// not given is null.
nlohmann::ordered_json settings_json(const RenderParams& params);

}  // namespace lippmann
