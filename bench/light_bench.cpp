// Path-traced light with reuse beside full path tracing: what it saves, how near to the truth both are, flicker and memory;
// against the bars that the reuse has to clear.
#include <fmt/core.h>

#include "bench/benchmarks.hpp"
#include "bench/light_json.hpp"
#include "bench/light_references.hpp"
#include "bench/light_rows.hpp"
#include "bench/light_run.hpp"
#include "bench/light_text.hpp"

namespace lippmann::bench {
namespace {

LightSettings settings_of(const Request& request) {
  LightSettings settings;
  settings.references = request.references.empty() ? default_reference_folder() : std::filesystem::path(request.references);
  settings.pictures = request.pictures;
  settings.denoise = request.denoise;
  settings.say = request.say;
  return settings;
}

}  // namespace

Report measure_light(const Request& request, const Context& context) {
  Report report;
  if (request.list) {
    report.text = light_row_list();
    return report;
  }
  const LightSettings settings = settings_of(request);
  int judged = 0, close = 0;
  for (const LightCase& wanted : light_cases(request, context)) {
    const LightRun run = run_light(wanted, settings, context);
    if (context.cancelled) break;
    const std::optional<LightBar> bar = light_bar(wanted.name);
    report.rows.push_back(light_json(wanted, run, bar));
    report.text += light_text(wanted, run, bar);
    report.passed_checks += run.passed_checks;
    judged += run.estimate.frames, close += run.estimate.close;
  }
  if (judged > 0)
    report.text += fmt::format("PSNR by their own estimate within {:.1f} dB: {} of {} frames, {:.1f} %\n", kCloseDb, close,
                               judged, 100.0 * close / judged);
  return report;
}

}  // namespace lippmann::bench
