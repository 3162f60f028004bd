// Measures how much time reuse between frames saves compared with full tracing, and the PSNR of the frames.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "bench/benchmarks.hpp"
#include "bench/reuse_run.hpp"
#include "bench/rounded_json.hpp"
#include "bench/tachyon_animation.hpp"
#include "bench/timing.hpp"

namespace lippmann::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kFloor = 50.0;  // minimum PSNR of interpolated frames, in dB
constexpr int kRounds = 3;

std::vector<ReuseMethod> reuse_methods(RenderParams params) {
  params.reuse.choice = ReuseChoice::kCopy;
  const ReuseMethod exact{"exact", params};
  params.reuse.choice = ReuseChoice::kInterpolate;
  params.reuse.min_psnr_db = kFloor;
  return {exact, {fmt::format("forward, {:.0f} dB", kFloor), params}};
}

/// psnr_db is the mean over the frames that differ from the traced frames, or null if none differs. tachyon_ratio is the time
/// of the program tachyon for the same number of pixels, divided by our time.
Json row_of(const ReuseRun& run, std::optional<double> tachyon_seconds) {
  const double frames = static_cast<double>(run.frames.size());
  const Json ratio = tachyon_seconds ? Json(rounded(*tachyon_seconds * frames / run.seconds())) : Json(nullptr);
  return {{"scene", run.scene},
          {"method", run.method},
          {"keyframes", "auto"},
          {"frames", run.frames.size()},
          {"whole_frames", std::count_if(run.frames.begin(), run.frames.end(), [](const ReuseFrame& f) { return f.key; })},
          {"traced_ms", rounded(1e3 * run.traced_seconds() / frames)},
          {"saving_in_between", rounded(run.saving_in_between())},
          {"saving_total", rounded(run.saving())},
          {"tachyon_ratio", ratio},
          {"psnr_db", rounded_or_null(run.mean_psnr())},
          {"min_psnr_db", rounded_or_null(run.min_psnr())},
          {"moving_psnr_db", rounded_or_null(run.mean_moving_psnr())},
          {"blend_psnr_db", rounded_or_null(run.mean_blend_psnr())},
          {"ssim", rounded(run.mean_ssim())}};
}

}  // namespace

Report measure_reuse(const Request& request, const Context& context) {
  Report report;
  for (const BenchAnimation& animation : bench_animations(request, context)) {
    const std::vector<ReuseRun> runs = run_reuse(animation, reuse_methods(animation.params), request, context, kRounds);
    const auto tachyon_seconds = tachyon_seconds_per_frame(animation, static_cast<double>(runs.front().pixels));
    for (const ReuseRun& run : runs) {
      report.rows.push_back(row_of(run, tachyon_seconds));
      for (const ReuseFrame& frame : run.frames) report.passed_checks += frame.key;
    }
  }
  return report;
}

}  // namespace lippmann::bench
