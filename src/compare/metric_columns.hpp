// The metrics of an image as columns of tables, CSV and JSON.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "compare/compare.hpp"

namespace lippmann {

struct MetricColumn {
  std::string_view key;    ///< name of the metric in JSON and CSV
  std::string_view title;  ///< heading in tables
  int digits = 4;          ///< number of decimals in tables
  bool worst_is_largest = false;
  /// Returns the metric's value; empty if it was not requested or is undefined (too small an image, or the PSNR of equal
  /// images).
  std::optional<double> (*of)(const PictureMetrics& metrics);
  /// Returns whether tables include the column.
  bool (*is_chosen)(const MetricChoice& choice);
};

std::span<const MetricColumn> metric_columns();

/// Returns the mean over the frames that have a value, and worst_of() the worst value; nullopt if no frame has one.
std::optional<double> mean_of(const MetricColumn& column, const Comparison& comparison);
std::optional<double> worst_of(const MetricColumn& column, const Comparison& comparison);

}  // namespace lippmann
