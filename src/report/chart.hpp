// Charts of figures over the frames of a render, as lines or stacked bars. The page contains the data of the charts as JSON.
// The page's script draws them (web/src/report.ts).
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lippmann {

struct ChartSeries {
  std::string name;
  /// Index of the colour, 0 to 7. The style of the page defines the colours --c0 to --c7.
  int color = 0;
  std::vector<std::optional<double>> values;  ///< one value per frame; nullopt if unknown
};

/// A horizontal line with a name, which marks a reference value.
struct ChartLevel {
  std::string name;
  double value = 0.0;
};

/// A chart. All text is plain, not HTML.
struct Chart {
  std::string title = {}, unit = {};
  std::vector<int> frames = {};
  std::vector<ChartSeries> series = {};
  std::vector<ChartLevel> levels = {};
  bool is_stacked = false;  ///< whether the series are drawn as stacked bars instead of lines
  /// Whether the value axis starts at zero. With bars it always does.
  bool starts_at_zero = true;
  /// Upper end of the value axis. If nullopt, just above the largest value.
  std::optional<double> top = {};
};

/// Returns the HTML of a chart. Returns an empty string if no series has a finite value. Values are stored with six digits.
std::string chart_html(const Chart& chart);

/// Returns the HTML of all charts that have values. They are placed side by side if there is room.
std::string charts_html(const std::vector<Chart>& charts);

}  // namespace lippmann
