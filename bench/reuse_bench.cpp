// What reuse between frames saves of our own full tracing, and how near to it the pictures are: whole animations, key frames
// counted.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "bench/benchmarks.hpp"
#include "bench/reuse_run.hpp"
#include "bench/timing.hpp"

namespace lippmann::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kFloor = 50.0;  // dB

std::vector<ReuseMethod> reuse_methods(RenderParams params) {
  std::vector<ReuseMethod> methods;
  params.reuse = Reuse::kForward;
  for (const int interval : {2, 8}) {
    params.keyframes = interval;
    methods.push_back({"forward", params});
  }
  params.keyframes.reset();
  params.min_psnr_db = kFloor;
  methods.push_back({fmt::format("forward, {:.0f} dB", kFloor), params});
  params.min_psnr_db.reset();
  params.reuse = Reuse::kExact;
  methods.push_back({"exact", params});
  return methods;
}

Json finite_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(rounded(*value)) : Json(nullptr);
}

/// psnr_db: of the frames that differ from the traced ones, null where none does.
Json row_of(const ReuseRun& run, bool planned) {
  const double frames = static_cast<double>(run.frames.size());
  return {{"scene", run.scene},
          {"method", run.method},
          {"keyframes", planned ? Json("auto") : Json(run.keyframes)},
          {"frames", run.frames.size()},
          {"whole_frames", std::count_if(run.frames.begin(), run.frames.end(), [](const ReuseFrame& f) { return f.key; })},
          {"traced_ms", rounded(1e3 * run.traced_seconds() / frames)},
          {"saving_in_between", rounded(run.saving_in_between())},
          {"saving_total", rounded(run.saving())},
          {"psnr_db", finite_or_null(run.mean_psnr())},
          {"min_psnr_db", finite_or_null(run.min_psnr())},
          {"moving_psnr_db", finite_or_null(run.mean_moving_psnr())},
          {"blend_psnr_db", finite_or_null(run.mean_blend_psnr())},
          {"ssim", rounded(run.mean_ssim())}};
}

}  // namespace

Report measure_reuse(const Request& request, const Context& context) {
  Report report;
  for (const BenchAnimation& animation : bench_animations(request, context)) {
    const std::vector<ReuseMethod> methods = reuse_methods(animation.params);
    const std::vector<ReuseRun> runs = run_reuse(animation, methods, context);
    for (std::size_t m = 0; m < runs.size(); ++m) {
      report.rows.push_back(row_of(runs[m], !methods[m].params.keyframes.has_value()));
      for (const ReuseFrame& frame : runs[m].frames) report.passed_checks += frame.key;
    }
  }
  return report;
}

}  // namespace lippmann::bench
