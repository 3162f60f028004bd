// Prints the report of a benchmark on standard output.
#pragma once

#include <string_view>

#include "bench/bench.hpp"

namespace lippmann::bench {

/// Prints the text of the report, or its rows as a table if there is no text. Also prints the number of passed checks.
void print_table(const Report& report);

/// Prints a JSON object with "bench", "machine", "rows" and "passed_checks". It also has "details" if the report has details.
void print_json(std::string_view benchmark, const Report& report, const Context& context);

}  // namespace lippmann::bench
