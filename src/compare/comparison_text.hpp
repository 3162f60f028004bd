// Formats a Comparison as JSON, CSV or a table for people.
#pragma once

#include <string>

#include "compare/compare.hpp"

namespace lippmann {

/// Returns {"frames": [{"name", "mse": {"r", "g", "b", "mean"}, "rmse": {...}, "psnr_db", "ssim", "psnr_y_db", "psnr_yuv_db"}],
/// "mean": {"mse": {...}, "rmse": {...}, "psnr_db", ...}, "worst": {"psnr_db", ...}, "identical"}. Undefined values are null,
/// such as psnr_db of identical images. If requested, adds "ms_ssim" and "flip" beside "ssim", and "consistency": [{"name",
/// "angular_psnr_db", "flicker"}].
std::string comparison_json(const Comparison& comparison);

/// Returns a line of titles, followed by one line per frame. Undefined values are empty. Names are quoted as in RFC 4180.
std::string comparison_csv(const Comparison& comparison);

/// Returns a table with the requested columns. It has one line per frame, a line with the means and a line with the worst
/// values.
std::string comparison_table(const Comparison& comparison, const MetricChoice& choice = {});

}  // namespace lippmann
