#pragma once

#include <nlohmann/json_fwd.hpp>

namespace lippmann::app {

/// Prints JSON to stdout, with an indent of two spaces and a final newline.
void print_json(const nlohmann::ordered_json& json);

}  // namespace lippmann::app
