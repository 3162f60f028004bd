// The metrics of an image as columns of tables, CSV and JSON.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "compare/compare.hpp"

namespace lippmann {

struct MetricColumn {
  std::string_view key;  ///< name of the metric in JSON and CSV
  std::string_view title;
  int digits = 4;  ///< number of decimals in tables
  bool worst_is_largest = false;
  /// Returns the value of the metric. Returns nullopt if the metric was not requested or is undefined. It is undefined if the
  /// image is too small. The PSNR of equal images is undefined too.
  std::optional<double> (*of)(const PictureMetrics& metrics);
  /// Returns whether tables include the column.
  bool (*is_chosen)(const MetricChoice& choice);
};

std::span<const MetricColumn> metric_columns();

/// mean_of() returns the mean over the frames that have a value. worst_of() returns the worst value. Both return nullopt if no
/// frame has a value.
std::optional<double> mean_of(const MetricColumn& column, const Comparison& comparison);
std::optional<double> worst_of(const MetricColumn& column, const Comparison& comparison);

}  // namespace lippmann
