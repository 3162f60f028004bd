#include "job/unit_plan.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <set>

#include "distribute/units.hpp"
#include "frames/frame_maker.hpp"
#include "job/animation.hpp"
#include "job/job_stage.hpp"
#include "job/reuse_params.hpp"
#include "job/test_pattern.hpp"
#include "lippmann/core/parallel.hpp"

namespace lippmann {
namespace {

/// The first two frames of the first, the middle and the last of these segments.
std::vector<int> frames_to_measure(const std::vector<std::vector<int>>& segments) {
  std::set<int> frames;
  for (const std::size_t i : {std::size_t{0}, segments.size() / 2, segments.size() - 1})
    frames.insert(segments[i].begin(), segments[i].begin() + std::min<std::ptrdiff_t>(2, std::ssize(segments[i])));
  return {frames.begin(), frames.end()};
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

FrameCosts measured(FrameMaker& maker, const std::vector<int>& frames, int segment, const Context& context) {
  FrameCosts costs;
  std::vector<double> first, other;
  for (const int frame : frames) {
    if (context.cancelled) break;
    const RenderedFrame rendered = maker.make(frame);
    if (context.cancelled) break;
    (frame % segment == 0 ? first : other).push_back(rendered.report.cpu_seconds);
    costs.frames.push_back(frame);
  }
  costs.first_cpu_seconds = mean(first.empty() ? other : first);
  costs.other_cpu_seconds = mean(other.empty() ? first : other);
  double sources = 0.0;
  for (const FrameReport& source : maker.sources()) sources += source.cpu_seconds;
  constexpr double kPlaces = 3.0;  // where frames were measured
  costs.source_cpu_seconds = sources / kPlaces;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  costs.peak_memory_bytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  return costs;
}

double cpu_seconds_of(const std::vector<int>& frames, int segment, const FrameCosts& costs) {
  const auto firsts = std::count_if(frames.begin(), frames.end(), [&](int frame) { return frame % segment == 0; });
  return costs.setup_seconds + costs.source_cpu_seconds + static_cast<double>(firsts) * costs.first_cpu_seconds +
         static_cast<double>(std::ssize(frames) - firsts) * costs.other_cpu_seconds;
}

}  // namespace

UnitPlan plan_units(const RenderParams& wanted, int count, bool measure, const Context& context) {
  const auto begin = std::chrono::steady_clock::now();
  const RenderParams params = with_scene_defaults(wanted);
  const FrameParams made_as = frame_params(params);
  const ThreadPool pool(params.threads > 0 ? params.threads : resolved_threads(context));
  JobStage stage(params, pool, context);
  const std::vector<int> frames = frames_of_job(params, stage.scene.timeline);
  UnitPlan plan;
  plan.segment = frames_per_segment(made_as);
  for (std::vector<int>& unit : units_of(frames, plan.segment, count)) plan.units.push_back({std::move(unit)});
  if (!measure) return plan;
  const double setup = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const auto maker =
      params.scene.name == kTestPattern ? make_pattern_frames(stage, pool) : make_frame_maker(stage, made_as, pool, context);
  const std::vector<std::vector<int>> segments = units_of(frames, plan.segment, static_cast<int>(frames.size()));
  plan.costs = measured(*maker, frames_to_measure(segments), plan.segment, context);
  plan.costs->setup_seconds = setup;
  for (PlannedUnit& unit : plan.units) unit.cpu_seconds = cpu_seconds_of(unit.frames, plan.segment, *plan.costs);
  return plan;
}

}  // namespace lippmann
