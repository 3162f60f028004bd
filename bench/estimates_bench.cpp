// Whether frames of shared light are as good as they are told to be (estimated_psnr_db of report.json): every frame of many
// histories, in pictures of several shapes, beside references.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bench/benchmarks.hpp"
#include "bench/light_references.hpp"
#include "bench/light_rows.hpp"
#include "bench/light_run.hpp"

namespace lippmann::bench {
namespace {

/// References are rendered in two halves whose errors have nothing to do with each other.
constexpr int kReferenceSamples = 256;
/// A history; among fewer frames the first, which is known worst, would count for more.
constexpr int kHistory = 16;

struct Shape {
  std::string views;
  int view_pixels;
};

/// Hostile scenes, and built-in ones in which light is shared.
std::vector<std::string> all_scenes() {
  return {"bar-sun",     "bar-lamp",   "fast-lamp", "fast-point", "tiny-lamp",   "flash",    "mirrors",
          "glass",       "gloss",      "thin",      "flight",     "walker",      "textured", "furnished",
          "millimetres", "kilometres", "room",      "tree",       "small-balls", "teapot"};
}

std::vector<Shape> shapes_of(const Request& request) {
  if (!request.views.empty() || request.view_pixels > 0) return {{request.views, request.view_pixels}};
  if (request.quick) return {{"3x1", 24}};
  return {{"3x1", 120}, {"3x1", 96}, {"8x6", 32}};
}

std::vector<LightCase> cases_of(Request request, const Shape& shape, const Context& context) {
  request.views = shape.views, request.view_pixels = shape.view_pixels;
  if (request.scenes.empty()) request.scenes = all_scenes();
  if (request.frames == 0 && !request.quick) request.frames = kHistory;
  if (request.reference_spp == 0 && !request.quick) request.reference_spp = kReferenceSamples;
  std::vector<LightCase> cases = light_cases(request, context);
  for (LightCase& wanted : cases) wanted.reference_step = 1;
  return cases;
}

/// What frames are told, beside what is true.
struct Told {
  std::vector<double> excess_db;  ///< told PSNR less the true one, by frame
  std::size_t bounds_held = 0;    ///< frames whose true PSNR is no lower than psnr_at_least_db

  std::size_t frames() const { return excess_db.size(); }
  std::size_t close() const {
    return static_cast<std::size_t>(
        std::count_if(excess_db.begin(), excess_db.end(), [](double e) { return std::abs(e) <= kCloseDb; }));
  }
  double percent(std::size_t part) const {
    return 100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(frames(), 1));
  }
  double mean() const {
    double sum = 0.0;
    for (const double e : excess_db) sum += e;
    return sum / static_cast<double>(std::max<std::size_t>(frames(), 1));
  }
  double most() const {
    double most = 0.0;
    for (const double e : excess_db) most = std::max(most, std::abs(e));
    return most;
  }
  void add(double told_db, double at_least_db, double true_db) {
    excess_db.push_back(told_db - true_db);
    bounds_held += true_db >= at_least_db ? 1 : 0;
  }
  void add(const Told& more) {
    excess_db.insert(excess_db.end(), more.excess_db.begin(), more.excess_db.end());
    bounds_held += more.bounds_held;
  }
};

/// Frames from `first` to before `end`, which begin a history or go on with it.
Told told_of(const LightRun& run, std::size_t first, std::size_t end) {
  Told told;
  for (std::size_t f = first; f < std::min(end, run.estimates_db.size()); ++f)
    if (run.estimates_db[f] && run.at_least_db[f] && std::isfinite(run.reuse.psnr_db_by_frame[f]))
      told.add(*run.estimates_db[f], *run.at_least_db[f], run.reuse.psnr_db_by_frame[f]);
  return told;
}

nlohmann::ordered_json json_of(const LightCase& wanted, const LightRun& run, const Told& told) {
  nlohmann::ordered_json by_frame = nlohmann::ordered_json::array();
  for (const double e : told.excess_db) by_frame.push_back(std::round(e * 1e3) / 1e3);
  return {{"scene", wanted.name},
          {"width", run.width},
          {"height", run.height},
          {"frames", told.frames()},
          {"psnr_db", run.reuse.psnr_db},
          {"close_frames", told.close()},
          {"bounds_held", told.bounds_held},
          {"mean_excess_db", told.mean()},
          {"largest_error_db", told.most()},
          {"excess_db_by_frame", by_frame}};
}

std::string line_of(const std::string& name, const std::string& size, const Told& told) {
  return fmt::format("{:<12} {:>9} {:>7} {:>11} {:>7.1f} {:>14.1f} {:>+12.2f} {:>9.2f}\n", name, size, told.frames(),
                     told.close(), told.percent(told.close()), told.percent(told.bounds_held), told.mean(), told.most());
}

}  // namespace

Report measure_estimates(const Request& request, const Context& context) {
  LightSettings settings;
  settings.references = request.references.empty() ? default_reference_folder() : std::filesystem::path(request.references);
  settings.say = request.say;
  settings.without_full = true;
  Report report;
  report.text = fmt::format("{:<12} {:>9} {:>7} {:>11} {:>7} {:>14} {:>12} {:>9}\n", "scene", "pixels", "frames", "within 0.5",
                            "%", "bound holds, %", "mean, dB", "most, dB");
  Told all, firsts;
  for (const Shape& shape : shapes_of(request))
    for (const LightCase& wanted : cases_of(request, shape, context)) {
      const LightRun run = run_light(wanted, settings, context);
      if (context.cancelled) return report;
      const Told told = told_of(run, 0, run.estimates_db.size());
      all.add(told), firsts.add(told_of(run, 0, 1));
      report.rows.push_back(json_of(wanted, run, told));
      report.text += line_of(wanted.name, fmt::format("{}x{}", run.width, run.height), told);
      report.passed_checks += run.passed_checks;
    }
  report.text += line_of("first frames", "", firsts) + line_of("all", "", all);
  return report;
}

}  // namespace lippmann::bench
