#include "frames/strip_maker.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numeric>
#include <optional>

#include "frames/frame_maker.hpp"
#include "frames/traced_frames.hpp"
#include "lippmann/core/error.hpp"
#include "trace/strip_order.hpp"

namespace lippmann {
namespace {

constexpr const char* kStrips = "strips";

/// A strip has no key frame to copy from, so copying is replaced by tracing, which gives the same bits.
FrameParams made_alone(FrameParams params) {
  params.reuse = resolved_reuse(params);
  if (std::holds_alternative<CopySettled>(params.reuse)) params.reuse = TraceAll{};
  return params;
}

/// Combines the error intervals of independent strips by adding squared standard errors. In the intervals of frames/audit.hpp,
/// the standard error is proportional to mean * log(high / mean).
void combine_estimates(const std::vector<FrameReport>& strips, const std::vector<int>& rows, FrameReport& frame) {
  const double all_rows = std::accumulate(rows.begin(), rows.end(), 0.0);
  double mean = 0.0, squared_width = 0.0;
  frame.estimated_psnr_db = frame.psnr_at_least_db = frame.psnr_at_most_db = std::nullopt;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const FrameReport& strip = strips[i];
    // A strip without an estimate has only exact pixels, such as background.
    if (!strip.psnr_at_least_db) continue;
    const double share = rows[i] / all_rows, high = std::pow(10.0, -0.1 * *strip.psnr_at_least_db);
    double width = high;
    if (strip.estimated_psnr_db) {
      const double of_strip = std::pow(10.0, -0.1 * *strip.estimated_psnr_db);
      mean += share * of_strip;
      width = of_strip * std::log(high / of_strip);
    }
    squared_width += share * width * share * width;
  }
  if (!(squared_width > 0.0)) return;
  const double width = std::sqrt(squared_width);
  const auto psnr = [](double error) { return -10.0 * std::log10(error); };
  frame.psnr_at_least_db = psnr(mean > 0.0 ? mean * std::exp(width / mean) : width);
  if (!(mean > 0.0)) return;
  frame.estimated_psnr_db = psnr(mean);
  frame.psnr_at_most_db = psnr(mean * std::exp(-width / mean));
}

void add_costs(const FrameReport& strip, FrameReport& frame) {
  frame.seconds += strip.seconds, frame.cpu_seconds += strip.cpu_seconds;
  add(strip.rays, frame.rays);
}

}  // namespace

int most_strips(const Optics& optics) {
  const int together = rows_per_strip(optics);
  return (film_size(optics).y + together - 1) / together;
}

StripMaker::StripMaker(Stage& stage, const FrameParams& params, int strips, const ThreadPool& pool, const Context& context)
    : stage_(stage), params_(made_alone(params)), strips_(strips), pool_(pool), context_(context) {}

FilmRows StripMaker::rows_of(int strip) const {
  const Optics& optics = stage_.placed.optics;
  const std::int64_t bands = most_strips(optics);
  const auto row = [&](int i) {
    return std::min(static_cast<int>(i * bands / strips_) * rows_per_strip(optics), film_size(optics).y);
  };
  return {row(strip), row(strip + 1)};
}

RenderedFrame StripMaker::make(int frame, int strip) {
  stage_.rows = rows_of(strip);
  return make_frame_maker(stage_, params_, pool_, context_)->make(frame);
}

void check_strips(const FrameParams& params, const Optics& optics, int strips) {
  const int most = most_strips(optics), together = rows_per_strip(optics);
  if (strips > most)
    throw usage_error(kStrips,
                      fmt::format("{} are too many: the picture has {} rows, of which each strip needs at least {}", strips,
                                  film_size(optics).y, together),
                      fmt::format("1 to {}", most));
  if (std::holds_alternative<Interpolate>(params.reuse))
    throw usage_error(kStrips, "strips are rendered separately, and interpolated frames need whole key frames",
                      "1, or `reuse` none or copy");
  if (strips > 1 && rows_around(params.sampling, optics) >= film_size(optics).y)
    throw usage_error(kStrips, "the denoiser averages views of all rows of the quilt: each strip would trace the whole frame",
                      "1, or `denoise` none");
}

FrameReport report_of_strips(const std::vector<FrameReport>& strips, const std::vector<int>& rows) {
  FrameReport frame = strips.front();
  for (std::size_t i = 1; i < strips.size(); ++i) add_costs(strips[i], frame);
  combine_estimates(strips, rows, frame);
  return frame;
}

}  // namespace lippmann
