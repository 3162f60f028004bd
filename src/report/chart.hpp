// Charts of figures over frames, as lines or stacked bars. The page contains them as JSON, and its script draws them
// (web/src/report.ts).
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lippmann {

struct ChartSeries {
  std::string name;
  int color = 0;                              ///< 0 ... 7: --c0 ... --c7 of the page's style
  std::vector<std::optional<double>> values;  ///< one per frame; none: unknown
};

/// A reference level: a horizontal line with its name.
struct ChartLevel {
  std::string name;
  double value = 0.0;
};

/// All text is plain.
struct Chart {
  std::string title = {}, unit = {};
  std::vector<int> frames = {};  ///< in ascending order
  std::vector<ChartSeries> series = {};
  std::vector<ChartLevel> levels = {};
  bool is_stacked = false;         ///< bars instead of lines
  bool starts_at_zero = true;      ///< of the value axis; bars always start at zero
  std::optional<double> top = {};  ///< end of the value axis; none: above the largest value
};

/// Returns HTML; empty if no series has a finite value. Values keep six digits.
std::string chart_html(const Chart& chart);

/// Returns the charts that have values, side by side if there is room.
std::string charts_html(const std::vector<Chart>& charts);

}  // namespace lippmann
