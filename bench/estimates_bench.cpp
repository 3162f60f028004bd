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

/// By how many decibels the PSNR that frames are told is above their true one.
struct Excesses {
  std::vector<double> db;

  std::size_t close() const {
    return static_cast<std::size_t>(std::count_if(db.begin(), db.end(), [](double e) { return std::abs(e) <= kCloseDb; }));
  }
  double mean() const {
    double sum = 0.0;
    for (const double e : db) sum += e;
    return sum / static_cast<double>(std::max<std::size_t>(db.size(), 1));
  }
  double most() const {
    double most = 0.0;
    for (const double e : db) most = std::max(most, std::abs(e));
    return most;
  }
  void add(const Excesses& more) { db.insert(db.end(), more.db.begin(), more.db.end()); }
};

Excesses excesses_of(const LightRun& run) {
  Excesses excesses;
  for (std::size_t f = 0; f < run.estimates_db.size(); ++f)
    if (run.estimates_db[f] && std::isfinite(run.reuse.psnr_db_by_frame[f]))
      excesses.db.push_back(*run.estimates_db[f] - run.reuse.psnr_db_by_frame[f]);
  return excesses;
}

nlohmann::ordered_json json_of(const LightCase& wanted, const LightRun& run, const Excesses& excesses) {
  nlohmann::ordered_json by_frame = nlohmann::ordered_json::array();
  for (const double e : excesses.db) by_frame.push_back(std::round(e * 1e3) / 1e3);
  return {{"scene", wanted.name},
          {"width", run.width},
          {"height", run.height},
          {"frames", excesses.db.size()},
          {"psnr_db", run.reuse.psnr_db},
          {"close_frames", excesses.close()},
          {"mean_excess_db", excesses.mean()},
          {"largest_error_db", excesses.most()},
          {"excess_db_by_frame", by_frame}};
}

std::string line_of(const std::string& name, const std::string& size, const Excesses& excesses) {
  return fmt::format(
      "{:<12} {:>9} {:>7} {:>11} {:>7.1f} {:>+12.2f} {:>9.2f}\n", name, size, excesses.db.size(), excesses.close(),
      100.0 * static_cast<double>(excesses.close()) / static_cast<double>(std::max<std::size_t>(excesses.db.size(), 1)),
      excesses.mean(), excesses.most());
}

}  // namespace

Report measure_estimates(const Request& request, const Context& context) {
  LightSettings settings;
  settings.references = request.references.empty() ? default_reference_folder() : std::filesystem::path(request.references);
  settings.say = request.say;
  settings.without_full = true;
  Report report;
  report.text = fmt::format("{:<12} {:>9} {:>7} {:>11} {:>7} {:>12} {:>9}\n", "scene", "pixels", "frames", "within 0.5", "%",
                            "mean, dB", "most, dB");
  Excesses all, firsts;
  for (const Shape& shape : shapes_of(request))
    for (const LightCase& wanted : cases_of(request, shape, context)) {
      const LightRun run = run_light(wanted, settings, context);
      if (context.cancelled) return report;
      const Excesses excesses = excesses_of(run);
      all.add(excesses);
      if (!excesses.db.empty()) firsts.db.push_back(excesses.db.front());
      report.rows.push_back(json_of(wanted, run, excesses));
      report.text += line_of(wanted.name, fmt::format("{}x{}", run.width, run.height), excesses);
      report.passed_checks += run.passed_checks;
    }
  report.text += line_of("first frames", "", firsts) + line_of("all", "", all);
  return report;
}

}  // namespace lippmann::bench
