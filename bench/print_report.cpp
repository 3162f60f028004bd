#include "bench/print_report.hpp"

#include <algorithm>

#include "apps/lippmann/print.hpp"
#include "core/json_text.hpp"
#include "core/platform.hpp"

namespace lippmann::bench {
namespace {

using Json = nlohmann::ordered_json;

Json describe_machine(const Context& context) {
  return {{"cpu", platform::cpu_model()},
          {"threads", resolved_threads(context)},
          {"system", platform::system_name()},
          {"compiler", std::string("g++ ") + __VERSION__}};
}

std::string cell(const Json& value) {
  if (value.is_number_float()) return fmt::format("{:.4g}", value.get<double>());
  return value.is_string() ? value.get<std::string>() : json_to_text(value, -1);
}

void print_columns(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths;
  for (const auto& line : lines) {
    widths.resize(std::max(widths.size(), line.size()));
    for (std::size_t column = 0; column < line.size(); ++column) widths[column] = std::max(widths[column], line[column].size());
  }
  for (const auto& line : lines) {
    for (std::size_t column = 0; column < line.size(); ++column) app::print_out("{:>{}}  ", line[column], widths[column]);
    app::print_out("\n");
  }
}

}  // namespace

void print_table(const Report& report) {
  if (!report.text.empty()) {
    app::print_out("{}\n", report.text);
  } else if (!report.rows.empty()) {
    std::vector<std::vector<std::string>> lines(1);
    for (const auto& [key, ignored] : report.rows[0].items()) lines[0].push_back(key);
    for (const Json& row : report.rows) {
      lines.emplace_back();
      for (const Json& value : row) lines.back().push_back(cell(value));
    }
    print_columns(lines);
  }
  app::print_out("{} checks of results passed\n", report.passed_checks);
}

void print_json(std::string_view benchmark, const Report& report, const Context& context) {
  Json result{{"bench", benchmark},
              {"machine", describe_machine(context)},
              {"rows", report.rows},
              {"passed_checks", report.passed_checks}};
  if (!report.details.is_null()) result["details"] = report.details;
  app::print_out("{}\n", json_to_text(result));
}

}  // namespace lippmann::bench
