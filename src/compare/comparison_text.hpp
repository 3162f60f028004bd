// Formats a Comparison as JSON, CSV or a table for people.
#pragma once

#include <string>

#include "compare/compare.hpp"

namespace lippmann {

/// Returns {"frames": [{"name", "mse": {"r", "g", "b", "mean"}, "rmse": {...}, "psnr_db", "ssim", "psnr_y_db", "psnr_yuv_db"}],
/// "mean": {"mse": {...}, "rmse": {...}, "psnr_db", ...}, "worst": {"psnr_db", ...}, "identical"}, with further metrics if
/// requested. Undefined values are null.
std::string comparison_json(const Comparison& comparison);

/// Returns a line of titles and one line per frame. Undefined values are empty. Names are quoted as in RFC 4180.
std::string comparison_csv(const Comparison& comparison);

/// Returns the requested columns, with one line per frame and lines for the means and the worst values.
std::string comparison_table(const Comparison& comparison, const MetricChoice& choice = {});

}  // namespace lippmann
