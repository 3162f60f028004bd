// Charts over the frames of a render, as lines or stacked bars. The page holds their data as JSON, which its script draws
// (web/src/report.ts).
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lippmann {

struct ChartSeries {
  std::string name;
  /// Index of one of the CSS colours --c0 to --c7.
  int color = 0;
  std::vector<std::optional<double>> values;  ///< one value per frame; nullopt if unknown
};

struct ChartLevel {
  std::string name;
  double value = 0.0;
};

/// All text is plain, not HTML.
struct Chart {
  std::string title = {}, unit = {};
  std::vector<int> frames = {};
  std::vector<ChartSeries> series = {};
  std::vector<ChartLevel> levels = {};
  bool is_stacked = false;
  /// Whether the value axis of a line chart starts at zero. The value axis of stacked bars always does.
  bool starts_at_zero = true;
  /// Upper end of the value axis; nullopt: just above the largest value.
  std::optional<double> top = {};
};

/// Returns an empty string if no series has a finite value. Values are stored with six digits.
std::string chart_html(const Chart& chart);

std::string charts_html(const std::vector<Chart>& charts);

}  // namespace lippmann
