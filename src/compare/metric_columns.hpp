// The metrics of an image as columns of tables, CSV and JSON.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "compare/compare.hpp"

namespace lippmann {

struct MetricColumn {
  std::string_view key;  ///< name in JSON and CSV
  std::string_view title;
  int digits = 4;
  bool worst_is_largest = false;
  /// Returns nullopt if the metric was not requested or is undefined for these images.
  std::optional<double> (*of)(const PictureMetrics& metrics);
  bool (*is_chosen)(const MetricChoice& choice);
};

std::span<const MetricColumn> metric_columns();

/// Return the mean and the worst value over the frames that have a value, or nullopt if no frame has a value.
std::optional<double> mean_of(const MetricColumn& column, const Comparison& comparison);
std::optional<double> worst_of(const MetricColumn& column, const Comparison& comparison);

}  // namespace lippmann
