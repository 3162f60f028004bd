// Shared light with several seeds: what a change of it gains or loses, which a single run does not tell. A history that has to
// trace one frame more takes a tenth more rays, so that runs differ by more than most changes do.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "bench/benchmarks.hpp"
#include "bench/light_references.hpp"
#include "bench/light_rows.hpp"
#include "bench/light_run.hpp"

namespace lippmann::bench {
namespace {

constexpr int kSeeds = 4;
/// Far from each other, and from those of references: their paths must have nothing in common.
std::uint32_t seed_of(int run) { return 1000u * static_cast<std::uint32_t>(run + 1); }

/// Of a row, by seed.
using Runs = std::vector<LightFigures>;
using Figure = double LightFigures::*;

double mean_of(const Runs& runs, const std::function<double(const LightFigures&)>& value) {
  double sum = 0.0;
  for (const LightFigures& run : runs) sum += value(run);
  return sum / static_cast<double>(runs.size());
}

double mean_of(const Runs& runs, Figure figure) {
  return mean_of(runs, [&](const LightFigures& run) { return run.*figure; });
}

/// From the mean squared error.
double mean_db(const Runs& runs, Figure db) {
  return -10.0 * std::log10(mean_of(runs, [&](const LightFigures& run) { return std::pow(10.0, -0.1 * (run.*db)); }));
}

double least_of(const Runs& runs, Figure figure) {
  const auto less = [&](const LightFigures& a, const LightFigures& b) { return a.*figure < b.*figure; };
  return (*std::min_element(runs.begin(), runs.end(), less)).*figure;
}

double most_of(const Runs& runs, Figure figure) {
  const auto less = [&](const LightFigures& a, const LightFigures& b) { return a.*figure < b.*figure; };
  return (*std::max_element(runs.begin(), runs.end(), less)).*figure;
}

std::string seeds_heading() {
  return fmt::format("{:<12} {:>21} {:>7} {:>14} {:>7} {:>7} {:>8} {:>14}\n", "row", "million rays a frame", "CPU s",
                     "PSNR (worst)", "edges", "means", "light, %", "flicker, views");
}

std::string line_of(const LightCase& wanted, const Runs& runs) {
  const double frames = wanted.count, millions = 1e-6 / frames;
  using F = LightFigures;
  const std::string rays = fmt::format("{:.2f} ({:.2f} - {:.2f})", millions * mean_of(runs, &F::rays),
                                       millions * least_of(runs, &F::rays), millions * most_of(runs, &F::rays));
  const std::string psnr = fmt::format("{:.2f} ({:.2f})", mean_db(runs, &F::psnr_db), least_of(runs, &F::worst_psnr_db));
  return fmt::format("{:<12} {:>21} {:>7.2f} {:>14} {:>7.2f} {:>7.2f} {:>+8.2f} {:>14.3f}\n", wanted.name, rays,
                     mean_of(runs, &F::seconds) / frames, psnr, mean_db(runs, &F::edge_psnr_db),
                     mean_db(runs, &F::block_psnr_db), 100.0 * (mean_of(runs, &F::mean_light) - 1.0),
                     mean_of(runs, &F::view_flicker));
}

nlohmann::ordered_json json_number(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::round(value * 1e4) / 1e4;
}

nlohmann::ordered_json json_of(const LightCase& wanted, std::uint32_t seed, const LightFigures& run) {
  return {{"row", wanted.name},
          {"seed", seed},
          {"frames", wanted.count},
          {"rays", run.rays},
          {"cpu_seconds", json_number(run.seconds)},
          {"psnr_db", json_number(run.psnr_db)},
          {"edge_psnr_db", json_number(run.edge_psnr_db)},
          {"block_psnr_db", json_number(run.block_psnr_db)},
          {"worst_blocks_psnr_db", json_number(run.worst_blocks_psnr_db)},
          {"worst_psnr_db", json_number(run.worst_psnr_db)},
          {"mean_light", json_number(run.mean_light)},
          {"view_flicker", json_number(run.view_flicker)},
          {"frame_flicker", json_number(run.frame_flicker)}};
}

LightSettings settings_without_full(const Request& request) {
  LightSettings settings;
  settings.references = request.references.empty() ? default_reference_folder() : std::filesystem::path(request.references);
  settings.say = request.say;
  settings.denoise = request.denoise;
  settings.without_full = true;
  return settings;
}

}  // namespace

Report measure_seeds(const Request& request, const Context& context) {
  LightSettings settings = settings_without_full(request);
  Report report;
  report.text = seeds_heading();
  for (const LightCase& wanted : light_cases(request, context)) {
    Runs runs;
    for (int run = 0; run < (request.seeds > 0 ? request.seeds : kSeeds); ++run) {
      settings.seed = seed_of(run);
      const LightRun made = run_light(wanted, settings, context);
      if (context.cancelled) return report;
      runs.push_back(made.reuse);
      report.rows.push_back(json_of(wanted, *settings.seed, made.reuse));
      report.passed_checks += made.passed_checks;
    }
    const std::string line = line_of(wanted, runs);
    if (request.say) request.say(line.substr(0, line.size() - 1));  // rows take minutes each
    report.text += line;
  }
  return report;
}

}  // namespace lippmann::bench
