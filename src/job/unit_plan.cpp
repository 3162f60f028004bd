#include "job/unit_plan.hpp"

#include <time.h>

#include <variant>

#include "core/scratch_folder.hpp"
#include "distribute/units.hpp"
#include "frames/frame_maker.hpp"
#include "job/animation.hpp"
#include "job/job_stage.hpp"
#include "job/reuse_params.hpp"
#include "lippmann/core/parallel.hpp"

namespace lippmann {
namespace {

/// Of all threads, since the process began.
double process_cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Units without their costs.
UnitPlan cut(const std::vector<int>& frames, int segment, int count) {
  UnitPlan plan;
  plan.segment = segment;
  for (std::vector<int>& unit : units_of(frames, segment, count)) plan.units.push_back({std::move(unit)});
  return plan;
}

UnitPlan unmeasured_plan(const RenderParams& params, int count, const Context& context) {
  const ThreadPool pool(params.threads > 0 ? params.threads : resolved_threads(context));
  const JobStage stage(params, pool, context);
  return cut(frames_of_job(params, stage.scene.timeline), frames_per_segment(frame_params(params)), count);
}

/// The same job in a folder of its own, pictures and layers alone: videos are made by who finishes it.
RenderParams job_in(const std::filesystem::path& folder, RenderParams params) {
  params.output.folder = folder.string();
  params.output.video.clear();
  params.resume = false;
  return params;
}

Neighbours neighbours_in(const RenderParams& params) {
  const Reuse reuse = resolved_reuse(frame_params(params));
  if (std::holds_alternative<ShareLight>(reuse)) return Neighbours::kSettling;
  return std::holds_alternative<CopySettled>(reuse) ? Neighbours::kCopied : Neighbours::kOthers;
}

/// Renders frames as a unit does, writes their files, and takes the time of both.
UnitPlan measured_plan(const RenderParams& params, int count, const Context& context) {
  const ScratchFolder folder;
  UnitPlan plan;
  std::vector<int> frames;
  RunParams run;
  run.choose = [&](const std::vector<int>& of_job, int segment) {
    plan = cut(of_job, segment, count);
    frames = of_job;
    return frames_to_measure(of_job, segment, neighbours_in(params));
  };
  MeasuredRun measured;
  const double begin = process_cpu_seconds();
  RenderObserver observer;
  observer.planned = [&](const RenderPlan&) { measured.setup_cpu_seconds = process_cpu_seconds() - begin; };
  const RenderReport report = render_animation(job_in(folder.path(), params), context, observer, run);
  measured.cpu_seconds = process_cpu_seconds() - begin;
  measured.frames = report.frames, measured.sources = report.run.sources;
  measured.peak_memory_bytes = report.run.peak_memory_bytes;
  plan.costs = frame_costs(measured, frames, plan.segment);
  for (PlannedUnit& unit : plan.units) unit.cpu_seconds = cpu_seconds_of(unit.frames, plan.segment, *plan.costs);
  return plan;
}

}  // namespace

UnitPlan plan_units(const RenderParams& wanted, int count, bool measure, const Context& context) {
  const RenderParams params = with_scene_defaults(wanted);
  return measure ? measured_plan(params, count, context) : unmeasured_plan(params, count, context);
}

}  // namespace lippmann
