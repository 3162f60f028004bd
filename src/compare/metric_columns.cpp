#include "compare/metric_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lippmann {
namespace {

using Value = std::optional<double>;

Value finite_or_none(Value value) { return value && std::isfinite(*value) ? value : std::nullopt; }

constexpr std::array<MetricColumn, 6> kMetricColumns{{
    {"psnr_db", "PSNR dB", 4, false, [](const PictureMetrics& m) { return finite_or_none(m.psnr_db); },
     [](const MetricChoice&) { return true; }},
    {"ssim", "SSIM", 5, false, [](const PictureMetrics& m) { return finite_or_none(m.ssim); },
     [](const MetricChoice&) { return true; }},
    {"psnr_y_db", "PSNR-Y", 4, false, [](const PictureMetrics& m) { return finite_or_none(m.psnr_y_db); },
     [](const MetricChoice& choice) { return choice.psnr_y; }},
    {"psnr_yuv_db", "PSNR-YUV", 4, false, [](const PictureMetrics& m) { return finite_or_none(m.psnr_yuv_db); },
     [](const MetricChoice& choice) { return choice.psnr_yuv; }},
    {"ms_ssim", "MS-SSIM", 5, false, [](const PictureMetrics& m) { return finite_or_none(m.ms_ssim); },
     [](const MetricChoice& choice) { return choice.slow.ms_ssim; }},
    {"flip", "FLIP", 5, true, [](const PictureMetrics& m) { return finite_or_none(m.flip); },
     [](const MetricChoice& choice) { return choice.slow.flip; }},
}};

}  // namespace

std::span<const MetricColumn> metric_columns() { return kMetricColumns; }

std::optional<double> mean_of(const MetricColumn& column, const Comparison& comparison) {
  double sum = 0.0;
  int count = 0;
  for (const FrameComparison& frame : comparison.frames)
    if (const Value value = column.of(frame.metrics)) sum += *value, ++count;
  return count > 0 ? Value(sum / count) : std::nullopt;
}

std::optional<double> worst_of(const MetricColumn& column, const Comparison& comparison) {
  Value worst;
  for (const FrameComparison& frame : comparison.frames)
    if (const Value value = column.of(frame.metrics))
      worst = !worst ? *value : column.worst_is_largest ? std::max(*worst, *value) : std::min(*worst, *value);
  return worst;
}

}  // namespace lippmann
