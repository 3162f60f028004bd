// Prints what --json asks for on stdout.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace lippmann::app {

/// Indented by two spaces, and a line's end.
void print_json(const nlohmann::ordered_json& json);

}  // namespace lippmann::app
