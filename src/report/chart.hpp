// Plots of figures over frames as HTML and SVG, without any script: lines, or shares that stand on each other.
//
// The SVG is stretched to whatever room there is, and all text around it is HTML, so that it is as large on a phone as on a
// desktop. Pointing at a frame tells its figures. Colours come from the page's style (.c0, .c1, ...), one a series.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lippmann {

struct ChartSeries {
  std::string name;                           ///< plain text
  int color = 0;                              ///< 0 ... 7: .c0 ... .c7 of the style
  std::vector<std::optional<double>> values;  ///< one a slot; none: not known
};

/// A level to compare with: a line across, with its name.
struct ChartLevel {
  std::string name;
  double value = 0.0;
};

struct Chart {
  std::string title = {}, unit = {};    ///< plain text
  std::string note = {};                ///< HTML below the title; empty: none
  std::vector<std::string> slots = {};  ///< what stands across, from left to right: numbers of frames
  std::vector<ChartSeries> series = {};
  std::vector<ChartLevel> levels = {};
  bool is_stacked = false;         ///< bars on each other, from 0 on; else lines
  bool starts_at_zero = true;      ///< of lines; bars always do
  std::optional<double> top = {};  ///< where the axis ends; none: at the largest value
};

/// Lowest and highest value of the axis, and the step between its labels: 1, 2 or 5 times a power of ten.
struct ChartAxis {
  double low = 0.0, high = 1.0, step = 0.5;
};

/// low < high, both multiples of the step but for a given `top`; holds all finite values and levels.
ChartAxis chart_axis(const Chart& chart);

/// Empty where no series has a value.
std::string chart_html(const Chart& chart);

/// Those that have values, beside each other where there is room.
std::string charts_html(const std::vector<Chart>& charts);

}  // namespace lippmann
