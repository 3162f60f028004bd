// Optional metrics of a comparison; defined in docs/reference/metrics.md.
#pragma once

#include <string>
#include <vector>

#include "lippmann/image/metrics.hpp"

namespace lippmann {

struct MetricChoice {
  bool psnr_y = false, psnr_yuv = false;  ///< always computed; true: shown as columns of the table
  SlowMetrics slow = {};
  bool angular = false, flicker = false;  ///< angular: for light fields; flicker: for consecutive frames
};

/// Parses names separated by commas: psnr-y, psnr-yuv, ms-ssim, flip, angular, flicker, or "all". Also accepts psnr, ssim and
/// mse, which are always included. Throws a usage Error naming `metrics`.
MetricChoice read_metrics(const std::string& text);

}  // namespace lippmann
