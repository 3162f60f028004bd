// Path-traced light with reuse beside full path tracing: what it saves, how near to the truth both are, flicker and memory;
// against the bars that the reuse has to clear.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bench/benchmarks.hpp"
#include "bench/light_references.hpp"
#include "bench/light_run.hpp"
#include "bench/light_text.hpp"
#include "core/error.hpp"
#include "scene/builtin.hpp"

namespace lippmann::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFrames = 12, kReferenceSamples = 2048, kRowShare = 32;
constexpr int kQuickFrames = 3, kQuickSamples = 8, kQuickReferenceSamples = 64, kQuickRowShare = 4;

/// What is asked of the built-in scenes.
const std::vector<std::pair<std::string, LightBar>>& bars() {
  static const std::vector<std::pair<std::string, LightBar>> all{
      {"teapot", {0.96, 0.0, 10.0}}, {"room", {0.96, 0.0, 10.0}},     {"small-balls", {0.86, 0.0, {}}},
      {"tree", {0.75, -0.5, {}}},    {"room-quilt", {0.90, 0.0, {}}}, {"tree-quilt", {0.60, 0.0, {}}}};
  return all;
}

std::optional<LightBar> bar_of(const std::string& name) {
  for (const auto& [known, bar] : bars())
    if (known == name) return bar;
  return std::nullopt;
}

constexpr std::string_view kQuilt = "-quilt";

LightCase animation_of(const std::string& name, const Request& request, const Context& context) {
  LightCase result{name, name, false, {}, 0, 1};
  result.params.scene = name;
  result.params.integrator = Integrator::kPath;
  const int wanted = request.frames > 0 ? request.frames : request.quick ? kQuickFrames : kFrames;
  result.count = std::min(wanted, wanted_scene(result.params, context).timeline.frame_count);
  if (request.quick) result.params.spp = kQuickSamples, result.params.lenses = {8, 8};
  return result;
}

/// One frame of 48 views of 128 x 128 pixels.
LightCase quilt_of(const std::string& name, const Request& request) {
  LightCase result{name, name.substr(0, name.size() - kQuilt.size()), true, {}, 0, 1};
  result.params.scene = result.scene;
  result.params.integrator = Integrator::kPath;
  result.params.optics = OpticsKind::kMultiview;
  result.params.size = {8 * 128, 6 * 128};
  if (request.quick) result.params.spp = kQuickSamples, result.params.size = {8 * 16, 6 * 16};
  return result;
}

std::vector<LightCase> wanted_cases(const Request& request, const Context& context) {
  std::vector<std::string> names = request.scenes;
  if (names.empty())
    for (const auto& [name, bar] : bars()) names.push_back(name);
  std::vector<LightCase> cases;
  cases.reserve(names.size());
  for (const std::string& name : names)
    cases.push_back(name.ends_with(kQuilt) ? quilt_of(name, request) : animation_of(name, request, context));
  return cases;
}

LightSettings settings_of(const Request& request) {
  LightSettings settings;
  settings.reference_spp = request.quick ? kQuickReferenceSamples : kReferenceSamples;
  if (request.reference_spp > 0) settings.reference_spp = request.reference_spp;
  settings.row_share = request.quick ? kQuickRowShare : kRowShare;
  settings.references = request.references.empty() ? default_reference_folder() : std::filesystem::path(request.references);
  settings.say = request.say;
  return settings;
}

double to_digits(double value) { return std::round(value * 1e4) / 1e4; }

Json number(double value) { return std::isfinite(value) ? Json(to_digits(value)) : Json(nullptr); }

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

Json by_spp(const std::vector<TimedQuality>& measured) {
  Json list = Json::array();
  for (const TimedQuality& m : measured)
    list.push_back({{"spp", m.spp}, {"cpu_seconds", number(m.seconds)}, {"psnr_db", number(m.psnr_db)}});
  return list;
}

/// At least; null: nothing is asked.
Json bar_json(const std::optional<LightBar>& bar) {
  if (!bar) return nullptr;
  return {{"saving_total", bar->saving},
          {"gain_db", bar->gain_db},
          {"equal_time_gain_db", bar->equal_time_gain_db ? Json(*bar->equal_time_gain_db) : Json(nullptr)}};
}

Json row_of(const LightCase& wanted, const LightSettings& settings, const LightRun& run) {
  const LightFigures &full = run.full, &reuse = run.reuse;
  return {{"row", wanted.name},
          {"scene", wanted.scene},
          {"case", wanted.still ? "still quilt" : "animation"},
          {"width", run.width},
          {"height", run.height},
          {"frames", wanted.count},
          {"spp", samples_per_pixel(wanted.params)},
          {"reference_spp", settings.reference_spp},
          {"compared_pixels", run.compared_pixels},
          {"references_rendered", run.references_rendered},
          {"references_kept", run.references_kept},
          {"full_cpu_seconds", number(full.seconds)},
          {"cpu_seconds", number(reuse.seconds)},
          {"first_frame_cpu_seconds", number(reuse.first_seconds)},
          {"time_ratio", number(run.time_ratio())},
          {"saving_total", number(run.saving())},
          {"full_psnr_db", number(full.psnr_db)},
          {"psnr_db", number(reuse.psnr_db)},
          {"gain_db", number(run.gain_db())},
          {"cpu_seconds_by_frame", numbers(reuse.seconds_by_frame)},
          {"full_psnr_db_by_frame", numbers(full.psnr_db_by_frame)},
          {"psnr_db_by_frame", numbers(reuse.psnr_db_by_frame)},
          {"full_by_spp", by_spp(run.full_by_spp)},
          {"equal_time_psnr_db", number(run.equal_time_psnr_db)},
          {"equal_time_gain_db", number(run.equal_time_gain_db())},
          {"full_view_flicker", number(full.view_flicker)},
          {"view_flicker", number(reuse.view_flicker)},
          {"full_frame_flicker", number(full.frame_flicker)},
          {"frame_flicker", number(reuse.frame_flicker)},
          {"full_rays", full.rays},
          {"rays", reuse.rays},
          {"stated_bytes", number(run.stated_bytes)},
          {"grown_bytes", number(run.grown_bytes)},
          {"bar", bar_json(bar_of(wanted.name))}};
}

}  // namespace

Report measure_light(const Request& request, const Context& context) {
  Report report;
  const LightSettings settings = settings_of(request);
  for (const LightCase& wanted : wanted_cases(request, context)) {
    const LightRun run = run_light(wanted, settings, context);
    if (context.cancelled) break;
    report.rows.push_back(row_of(wanted, settings, run));
    report.text += light_text(wanted, settings, run, bar_of(wanted.name));
    report.passed_checks += run.passed_checks;
  }
  return report;
}

}  // namespace lippmann::bench
