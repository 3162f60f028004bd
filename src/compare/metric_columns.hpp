// The metrics of an image as columns of tables, CSV and JSON.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "compare/compare.hpp"

namespace lippmann {

struct MetricColumn {
  std::string_view key;    ///< in JSON and CSV
  std::string_view title;  ///< in tables
  int digits = 4;          ///< decimals in tables
  bool worst_is_largest = false;
  /// Returns the value; empty if not requested or undefined (too small an image, or the PSNR of equal images).
  std::optional<double> (*of)(const PictureMetrics& metrics);
  /// Returns whether tables include the column.
  bool (*is_chosen)(const MetricChoice& choice);
};

std::span<const MetricColumn> metric_columns();

/// The mean and the worst value over the frames that have one; none if no frame has.
std::optional<double> mean_of(const MetricColumn& column, const Comparison& comparison);
std::optional<double> worst_of(const MetricColumn& column, const Comparison& comparison);

}  // namespace lippmann
