// The metrics of a picture as columns of tables, CSV and JSON.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "compare/compare.hpp"

namespace lippmann {

struct MetricColumn {
  std::string_view key;    ///< in JSON and CSV
  std::string_view title;  ///< in tables
  int digits = 4;          ///< behind the point, in tables
  bool worst_is_largest = false;
  /// Empty if the picture has no such value (not chosen, too small, or the PSNR of equal pictures).
  std::optional<double> (*of)(const PictureMetrics& metrics);
  /// Whether a table has it.
  bool (*is_chosen)(const MetricChoice& choice);
};

std::span<const MetricColumn> metric_columns();

/// Over the frames that have a value; none if no frame has.
std::optional<double> mean_of(const MetricColumn& column, const Comparison& comparison);
std::optional<double> worst_of(const MetricColumn& column, const Comparison& comparison);

}  // namespace lippmann
