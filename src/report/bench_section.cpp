#include "report/bench_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/json_text.hpp"
#include "lippmann/core/error.hpp"
#include "report/html.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

std::string value_text(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_number_float()) return fmt::format("{:.4g}", value.get<double>());
  return value.is_string() ? value.get<std::string>() : json_to_text(value, -1);
}

std::vector<std::string> keys_of(const Json& rows) {
  std::vector<std::string> keys;
  for (const Json& row : rows)
    for (const auto& [key, ignored] : row.items())
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  return keys;
}

/// Returns the largest absolute value of a column, to which the bars of the column are scaled. 0 means no bars.
double largest_in(const Json& rows, const std::string& key) {
  double largest = 0.0;
  for (const Json& row : rows)
    if (row.contains(key) && row[key].is_number()) largest = std::max(largest, std::abs(row[key].get<double>()));
  return std::isfinite(largest) ? largest : 0.0;
}

std::string cell_html(const Json& row, const std::string& key, double largest) {
  if (!row.contains(key)) return {};
  const std::string text = escaped(value_text(row[key]));
  if (!row[key].is_number() || largest <= 0.0) return text;
  const double share = 100.0 * std::abs(row[key].get<double>()) / largest;
  return fmt::format("{}<i class=\"meter\" style=\"width:{:.1f}%\"></i>", text, std::min(share, 100.0));
}

std::string rows_html(const Json& rows) {
  const std::vector<std::string> keys = keys_of(rows);
  HtmlTable table{{}, {}, "bench"};
  for (const std::string& key : keys) table.head.push_back(escaped(key));
  std::vector<double> largest;
  for (const std::string& key : keys) largest.push_back(largest_in(rows, key));
  for (const Json& row : rows) {
    table.rows.emplace_back();
    for (std::size_t i = 0; i < keys.size(); ++i) table.rows.back().push_back(cell_html(row, keys[i], largest[i]));
  }
  return table_html(table);
}

std::string machine_html(const Json& result) {
  std::string html;
  if (const auto machine = result.find("machine"); machine != result.end() && machine->is_object())
    for (const auto& [name, value] : machine->items())
      html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", escaped(name), escaped(value_text(value)));
  return "<dl class=\"about\">" + html + "</dl>";
}

std::string details_html(const Json& result) {
  const auto details = result.find("details");
  if (details == result.end() || details->is_null()) return {};
  return fmt::format("<details><summary>Details of the rows</summary><pre>{}</pre></details>",
                     fmt::format("{}", escaped(json_to_text(*details))));
}

}  // namespace

bool is_bench_result(const Json& json) { return json.is_object() && json.contains("bench") && json.contains("rows"); }

std::string bench_section(const Json& result, const std::filesystem::path& path) {
  const Json& rows = result.at("rows");
  const bool are_rows =
      rows.is_array() && std::all_of(rows.begin(), rows.end(), [](const Json& row) { return row.is_object(); });
  if (!are_rows) throw Error(path.string(), "its rows are not a list of objects", "what `lippmann-bench` prints as JSON");
  const auto checks = result.find("passed_checks");
  const std::string passed =
      checks != result.end() ? fmt::format("<p class=\"note\">{} checks of results passed.</p>", escaped(value_text(*checks)))
                             : "";
  const std::string none = rows.empty() ? sentences_html({"The benchmark has no rows."}) : std::string();
  return fmt::format("<section><h2>bench {}</h2>{}{}{}{}{}</section>\n", escaped(value_text(result.at("bench"))), none,
                     rows_html(rows), passed, machine_html(result), details_html(result));
}

}  // namespace lippmann
