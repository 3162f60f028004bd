#include "report/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "report/html.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

bool is_known(const std::optional<double>& value) { return value && std::isfinite(*value); }

bool has_values(const ChartSeries& series) { return std::any_of(series.values.begin(), series.values.end(), is_known); }

Json short_number(const std::optional<double>& value) {
  return is_known(value) ? Json(std::strtod(fmt::format("{:.6g}", *value).c_str(), nullptr)) : Json();
}

Json series_json(const ChartSeries& series) {
  Json values = Json::array();
  for (const std::optional<double>& value : series.values) values.push_back(short_number(value));
  return {{"name", series.name}, {"color", series.color}, {"values", std::move(values)}};
}

Json chart_json(const Chart& chart) {
  Json series = Json::array(), levels = Json::array();
  for (const ChartSeries& one : chart.series) series.push_back(series_json(one));
  for (const ChartLevel& level : chart.levels) levels.push_back({{"name", level.name}, {"value", level.value}});
  return {{"title", chart.title},
          {"unit", chart.unit},
          {"frames", chart.frames},
          {"series", std::move(series)},
          {"levels", std::move(levels)},
          {"stacked", chart.is_stacked},
          {"from_zero", chart.is_stacked || chart.starts_at_zero},
          {"top", chart.top ? Json(*chart.top) : Json()}};
}

}  // namespace

std::string chart_html(const Chart& chart) {
  if (std::none_of(chart.series.begin(), chart.series.end(), has_values)) return {};
  return fmt::format("<figure class=\"chart\"><figcaption><b>{}</b> <span>{}</span></figcaption>{}</figure>\n",
                     escaped(chart.title), escaped(chart.unit), data_html(chart_json(chart)));
}

std::string charts_html(const std::vector<Chart>& charts) {
  std::string html;
  for (const Chart& chart : charts) html += chart_html(chart);
  if (html.empty()) return html;
  return "<noscript><p class=\"note\">Charts need JavaScript. The table of every frame has the same figures.</p></noscript>"
         "<div class=\"charts\">" +
         html + "</div>";
}

}  // namespace lippmann
