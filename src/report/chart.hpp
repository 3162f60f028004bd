// Charts of figures over frames: lines, or bars stacked on each other. They are written into the page as JSON, which its script
// draws (web/src/report.ts).
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lippmann {

struct ChartSeries {
  std::string name;
  int color = 0;                              ///< 0 ... 7: --c0 ... --c7 of the page's style
  std::vector<std::optional<double>> values;  ///< one per frame; none: not known
};

/// A level to compare with: a line across, with its name.
struct ChartLevel {
  std::string name;
  double value = 0.0;
};

/// All text is plain.
struct Chart {
  std::string title = {}, unit = {};
  std::vector<int> frames = {};  ///< ascending
  std::vector<ChartSeries> series = {};
  std::vector<ChartLevel> levels = {};
  bool is_stacked = false;         ///< bars; else lines
  bool starts_at_zero = true;      ///< the axis of values; that of bars always does
  std::optional<double> top = {};  ///< where the axis of values ends; none: above the largest value
};

/// HTML; empty where no series has a finite value. Values keep six digits.
std::string chart_html(const Chart& chart);

/// The charts that have values, beside each other where there is room.
std::string charts_html(const std::vector<Chart>& charts);

}  // namespace lippmann
