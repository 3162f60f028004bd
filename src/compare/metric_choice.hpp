// Optional metrics of a comparison. docs/reference/metrics.md defines the metrics.
#pragma once

#include <string>
#include <vector>

#include "lippmann/image/metrics.hpp"

namespace lippmann {

struct MetricChoice {
  /// These metrics are always computed; the flags decide whether the table shows them.
  bool psnr_y = false, psnr_yuv = false;
  SlowMetrics slow = {};
  /// `angular` is only for light fields, `flicker` only for consecutive frames with motion. Other inputs are an Error.
  bool angular = false, flicker = false;
  /// Also computes angular and flicker where the inputs allow. Other inputs cause a warning.
  bool all = false;

  bool tries_angular() const { return angular || all; }
  bool tries_flicker() const { return flicker || all; }
};

/// Parses names separated by commas: psnr-y, psnr-yuv, ms-ssim, flip, angular, flicker, or "all". Also accepts psnr, ssim and
/// mse, which are always included. Throws a usage Error naming `metrics`.
MetricChoice read_metrics(const std::string& text);

}  // namespace lippmann
