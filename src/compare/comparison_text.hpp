// Writes a Comparison as JSON, CSV or a table for people.
#pragma once

#include <string>

#include "compare/compare.hpp"

namespace lippmann {

/// {"frames": [{"name", "mse": {"r", "g", "b", "mean"}, "rmse": {...}, "psnr_db", "ssim", "psnr_y_db", "psnr_yuv_db"}], "mean":
/// {"mse": {...}, "rmse": {...}, "psnr_db", ...}, "worst": {"psnr_db", ...}, "identical"}; what has no value is null (psnr_db
/// of identical pictures). Where chosen: "ms_ssim" and "flip" beside "ssim", and "consistency": [{"name", "angular_psnr_db",
/// "flicker"}].
std::string comparison_json(const Comparison& comparison);

/// One line per frame below a line of titles; what has no value is empty. Names are quoted as RFC 4180 asks.
std::string comparison_csv(const Comparison& comparison);

/// One line per frame, then the mean and the worst, with the columns that were chosen.
std::string comparison_table(const Comparison& comparison, const MetricChoice& choice = {});

}  // namespace lippmann
