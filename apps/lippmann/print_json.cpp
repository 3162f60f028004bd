#include "apps/lippmann/print_json.hpp"

#include <fmt/core.h>

#include "apps/lippmann/print.hpp"
#include "core/json_text.hpp"

namespace lippmann::app {

void print_json(const nlohmann::ordered_json& json) { print_out("{}\n", json_to_text(json)); }

}  // namespace lippmann::app
