// Prints the report of a benchmark on standard output.
#pragma once

#include <string_view>

#include "bench/bench.hpp"

namespace lippmann::bench {

/// Prints the report's text, or its rows as a table, and the number of passed checks.
void print_table(const Report& report);

/// Prints {"bench", "machine", "rows", "passed_checks"} and, if there are any, "details".
void print_json(std::string_view benchmark, const Report& report, const Context& context);

}  // namespace lippmann::bench
