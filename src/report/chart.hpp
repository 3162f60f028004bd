// Charts of figures over the frames of a render, as lines or stacked bars. The page contains their data as JSON, and the page's
// script draws them (web/src/report.ts).
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lippmann {

struct ChartSeries {
  std::string name;
  int color = 0;                              ///< index of the colour, 0 to 7, for --c0 to --c7 of the page's style
  std::vector<std::optional<double>> values;  ///< one value per frame; none: unknown
};

/// A horizontal line with a name, which marks a reference value.
struct ChartLevel {
  std::string name;
  double value = 0.0;
};

/// A chart. All text is plain, not HTML.
struct Chart {
  std::string title = {}, unit = {};
  std::vector<int> frames = {};  ///< numbers of the frames, in ascending order
  std::vector<ChartSeries> series = {};
  std::vector<ChartLevel> levels = {};
  bool is_stacked = false;         ///< whether the series are drawn as stacked bars instead of lines
  bool starts_at_zero = true;      ///< whether the value axis starts at zero; with bars it always does
  std::optional<double> top = {};  ///< end of the value axis; none: just above the largest value
};

/// Returns the HTML of a chart; empty if no series has a finite value. Values are stored with six digits.
std::string chart_html(const Chart& chart);

/// Returns the HTML of those charts that have values, placed side by side if there is room.
std::string charts_html(const std::vector<Chart>& charts);

}  // namespace lippmann
