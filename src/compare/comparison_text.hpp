// Writes a Comparison as JSON, CSV or a table for people.
#pragma once

#include <string>

#include "compare/compare.hpp"

namespace lippmann {

/// {"frames": [{"name", "mse": {"r", "g", "b", "mean"}, "rmse": {...}, "psnr_db", "ssim"}], "mean": {"mse": {...}, "rmse":
/// {...}, "psnr_db", "ssim"}, "identical"}; what has no value is null (psnr_db of identical pictures).
std::string comparison_json(const Comparison& comparison);

/// One line per frame below a line of titles; what has no value is empty. Names are quoted as RFC 4180 asks.
std::string comparison_csv(const Comparison& comparison);

/// One line per frame, the mean last.
std::string comparison_table(const Comparison& comparison);

}  // namespace lippmann
