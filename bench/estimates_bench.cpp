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

/// Of references, in two halves: what these err by is multiplied, and weighs little beside what frames err by.
constexpr int kSamples = 256;
/// A history.
constexpr int kHistory = 16;

struct Shape {
  std::string views;
  int view_pixels;
};

/// Hostile scenes, and the built-in ones in which light is shared.
std::vector<std::string> all_scenes() {
  return {"bar-sun",     "bar-lamp",   "fast-lamp", "fast-point", "tiny-lamp",   "flash",    "mirrors",
          "glass",       "gloss",      "thin",      "flight",     "walker",      "textured", "furnished",
          "millimetres", "kilometres", "room",      "tree",       "small-balls", "teapot"};
}

std::vector<Shape> shapes_of(const Request& request) {
  if (!request.views.empty() || request.view_pixels > 0) return {{request.views, request.view_pixels}};
  return {{"3x1", 120}, {"3x1", 96}, {"8x6", 32}};
}

struct Tally {
  int frames = 0, close = 0;
  double excess_db = 0.0;

  void add(double excess) {
    ++frames, close += std::abs(excess) <= kCloseDb ? 1 : 0;
    excess_db += excess;
  }
  double share() const { return frames > 0 ? 100.0 * close / frames : std::nan(""); }
};

LightCase every_frame_of(LightCase wanted, const Request& request) {
  wanted.count = std::min(wanted.count, request.frames > 0 ? request.frames : kHistory);
  wanted.reference_step = 1;
  wanted.reference_spp = request.reference_spp > 0 ? request.reference_spp : request.quick ? wanted.reference_spp : kSamples;
  wanted.equal_time = false;
  return wanted;
}

}  // namespace

Report measure_estimates(const Request& request, const Context& context) {
  LightSettings settings;
  settings.references = request.references.empty() ? default_reference_folder() : std::filesystem::path(request.references);
  settings.say = request.say;
  settings.without_full = true;
  Report report;
  Tally all, firsts;
  report.text = fmt::format("{:<12} {:>9} {:>7} {:>12} {:>12} {:>10} {:>10}\n", "scene", "views", "frames", "true dB",
                            "told dB", "within 0.5", "most off");
  for (const Shape& shape : shapes_of(request)) {
    Request shaped = request;
    shaped.views = shape.views, shaped.view_pixels = shape.view_pixels;
    if (shaped.scenes.empty()) shaped.scenes = all_scenes();
    if (shaped.frames == 0) shaped.frames = kHistory;
    for (const LightCase& given : light_cases(shaped, context)) {
      const LightCase wanted = every_frame_of(given, shaped);
      const LightRun run = run_light(wanted, settings, context);
      if (context.cancelled) return report;
      report.passed_checks += run.passed_checks;
      Tally row;
      double truth = 0.0, told = 0.0, most = 0.0;
      nlohmann::ordered_json excesses = nlohmann::ordered_json::array();
      for (std::size_t f = 0; f < run.estimates_db.size(); ++f) {
        const double true_db = run.reuse.psnr_db_by_frame[f];
        if (!run.estimates_db[f] || !std::isfinite(true_db)) continue;
        const double excess = *run.estimates_db[f] - true_db;
        row.add(excess), all.add(excess);
        if (f == 0) firsts.add(excess);
        truth += true_db, told += *run.estimates_db[f], most = std::max(most, std::abs(excess));
        excesses.push_back(std::round(excess * 1e3) / 1e3);
      }
      const std::string views = fmt::format("{}x{}", run.width, run.height);
      const double frames = std::max(row.frames, 1);
      report.text += fmt::format("{:<12} {:>9} {:>7} {:>12.2f} {:>12.2f} {:>10} {:>10.2f}\n", wanted.name, views, row.frames,
                                 truth / frames, told / frames, row.close, most);
      report.rows.push_back({{"scene", wanted.name},
                             {"width", run.width},
                             {"height", run.height},
                             {"views", shape.views},
                             {"frames", row.frames},
                             {"true_psnr_db", truth / frames},
                             {"estimated_psnr_db", told / frames},
                             {"close_frames", row.close},
                             {"excess_db_by_frame", excesses}});
    }
  }
  report.text += fmt::format(
      "within {:.1f} dB of the true PSNR: {} of {} frames, {:.1f} %; of first frames {} of {}; {:+.2f} dB on average\n",
      kCloseDb, all.close, all.frames, all.share(), firsts.close, firsts.frames, all.excess_db / std::max(all.frames, 1));
  return report;
}

}  // namespace lippmann::bench
