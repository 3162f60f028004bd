#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "scene/gltf.hpp"
#include "scene/gltf/report.hpp"

namespace lippmann::gltf {

/// Returns the root object of the document. Throws Error with line and column for malformed text.
nlohmann::json parse_json(std::string_view text, const GltfLimits& limits, const Report& report);

}  // namespace lippmann::gltf
