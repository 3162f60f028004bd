#pragma once

#include <string_view>

#include "bench/bench.hpp"

namespace lippmann::bench {

void print_table(const Report& report);

void print_json(std::string_view benchmark, const Report& report, const Context& context);

}  // namespace lippmann::bench
