// Measures how often the PSNR interval that frames report (psnr_at_least_db to psnr_at_most_db in report.json) contains the
// true PSNR.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bench/benchmarks.hpp"
#include "bench/light_run.hpp"
#include "bench/rounded_json.hpp"
#include "bench/share_estimate.hpp"

namespace lippmann::bench {
namespace {

constexpr int kSeeds = 5, kQuickSeeds = 2, kFramesPerSeed = 4;

struct Intervals {
  /// numbers of all frames, and of frames whose interval contains, is below or is above the true PSNR
  int frames = 0, contain = 0, too_low = 0, too_high = 0;
  int bounded = 0;  ///< frames with an estimate and an interval; other frames have only a lower bound
  /// sums over the bounded frames: estimate minus true PSNR, and width of the interval
  double excess_db = 0.0, width_db = 0.0;

  void add(const FrameReport& report, double true_db) {
    if (!report.psnr_at_least_db || !std::isfinite(true_db)) return;
    const bool low = report.psnr_at_most_db && true_db > *report.psnr_at_most_db, high = true_db < *report.psnr_at_least_db;
    ++frames, too_low += low ? 1 : 0, too_high += high ? 1 : 0, contain += low || high ? 0 : 1;
    if (!report.estimated_psnr_db || !report.psnr_at_most_db) return;
    ++bounded;
    excess_db += *report.estimated_psnr_db - true_db;
    width_db += *report.psnr_at_most_db - *report.psnr_at_least_db;
  }
};

nlohmann::ordered_json row_of(const LightCase& row, Vec2i size, const Intervals& found) {
  const auto mean = [&](double sum) { return rounded_or_null(sum / found.bounded); };
  return {{"scene", row.name},
          {"width", size.x},
          {"height", size.y},
          {"frames", found.frames},
          {"contain_truth", found.contain},
          {"too_low", found.too_low},
          {"too_high", found.too_high},
          {"without_upper_bound", found.frames - found.bounded},
          {"mean_width_db", mean(found.width_db)},
          {"mean_excess_db", mean(found.excess_db)}};
}

std::string line_of(const LightCase& row, Vec2i size, const Intervals& found) {
  return fmt::format("{:<12} {:>9} {:>7} {:>14} {:>8} {:>9} {:>10.2f} {:>+13.2f}\n", row.name,
                     fmt::format("{}x{}", size.x, size.y), found.frames, found.contain, found.too_low, found.too_high,
                     found.width_db / found.bounded, found.excess_db / found.bounded);
}

}  // namespace

Report measure_estimates(const Request& request, const Context& context) {
  Request wanted = request;
  if (wanted.frames == 0) wanted.frames = kFramesPerSeed;
  Report report;
  report.text = fmt::format("{:<12} {:>9} {:>7} {:>14} {:>8} {:>9} {:>10} {:>13}\n", "scene", "pixels", "frames",
                            "contain truth", "too low", "too high", "width, dB", "estimate, dB");
  std::vector<Share> rows;
  for (const LightCase& row : light_cases(wanted, context)) {
    std::vector<Sampling> ways;
    for (int seed = 0; seed < (request.quick ? kQuickSeeds : kSeeds); ++seed) {
      ways.push_back(with_samples(row.params.sampling, Integrator::kPath.facts().default_samples, Denoise::kAuto));
      ways.back().seed = static_cast<std::uint32_t>(seed);
    }
    LightBench bench(row, request, context);
    Intervals found;
    for (const LightFigures& way : bench.measure(ways))
      for (std::size_t f = 0; f < way.reports.size(); ++f) found.add(way.reports[f], way.psnr_db_by_frame[f]);
    rows.push_back({found.contain, found.frames});
    report.rows.push_back(row_of(row, bench.film_size(), found));
    report.text += line_of(row, bench.film_size(), found);
    report.passed_checks += static_cast<int>(ways.size()) * row.count;
  }
  const ShareEstimate all = estimate_share(rows);
  report.text += fmt::format("{} of {} intervals contain the true PSNR: {:.1f} % +- {:.1f} % (one standard error)\n", all.hits,
                             all.trials, 100.0 * all.share, 100.0 * all.standard_error);
  report.details = {{"frames", all.trials},
                    {"contain_truth", all.hits},
                    {"share", rounded_or_null(all.share)},
                    {"standard_error", rounded_or_null(all.standard_error)}};
  return report;
}

}  // namespace lippmann::bench
