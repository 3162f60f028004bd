#include "apps/lippmann/print_json.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

namespace lippmann::app {

void print_json(const nlohmann::ordered_json& json) { fmt::print("{}\n", json.dump(2)); }

}  // namespace lippmann::app
