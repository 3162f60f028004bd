// Parses a glTF document's JSON within limits on depth and number of values.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "scene/gltf.hpp"
#include "scene/gltf/report.hpp"

namespace lippmann::gltf {

/// Returns the document's root object. Throws Error with line and column for malformed text.
nlohmann::json parse_json(std::string_view text, const GltfLimits& limits, const Report& report);

}  // namespace lippmann::gltf
