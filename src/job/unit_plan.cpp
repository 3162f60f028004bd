#include "job/unit_plan.hpp"

#include <time.h>

#include <variant>

#include "core/scratch_folder.hpp"
#include "distribute/units.hpp"
#include "frames/frame_maker.hpp"
#include "frames/strip_maker.hpp"
#include "job/animation.hpp"
#include "job/job_folder.hpp"
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

/// Units without their costs. parts: of frames that are rendered in so many strips (parts_of).
UnitPlan cut(const std::vector<int>& parts, int strips, int segment, int count) {
  UnitPlan plan;
  plan.segment = segment;
  for (const std::vector<int>& unit : units_of(parts, segment, count)) {
    plan.units.push_back({frames_of_parts(unit, strips)});
    if (strips > 1) plan.units.back().strips = strips_of_parts(unit, strips);
  }
  return plan;
}

int segment_of(const RenderParams& params) { return params.strips > 1 ? 1 : frames_per_segment(frame_params(params)); }

UnitPlan unmeasured_plan(const RenderParams& params, int count, const Context& context) {
  const ThreadPool pool(params.threads > 0 ? params.threads : resolved_threads(context));
  const JobStage stage(params, pool, context);
  if (params.strips > 1) check_strips(frame_params(params), stage.placed.optics, params.strips);
  return cut(parts_of(frames_of_job(params, stage.scene.timeline), params.strips), params.strips, segment_of(params), count);
}

/// The same job in a folder of its own, pictures and layers alone: videos are made by who finishes it.
RenderParams job_in(const std::filesystem::path& folder, RenderParams params) {
  params.output.folder = folder.string();
  params.output.video.clear();
  params.resume = false;
  return params;
}

Neighbours neighbours_in(const RenderParams& params) {
  if (params.strips > 1) return Neighbours::kOthers;
  return std::holds_alternative<CopySettled>(frame_params(params).reuse) ? Neighbours::kCopied : Neighbours::kOthers;
}

/// Renders frames as a unit does, writes their files, and takes the time of both.
UnitPlan measured_plan(const RenderParams& params, int count, const Context& context) {
  const ScratchFolder folder;
  UnitPlan plan;
  std::vector<int> parts;
  RunParams run;
  run.choose = [&](const std::vector<int>& of_job, int segment) {
    plan = cut(of_job, params.strips, segment, count);
    parts = of_job;
    return frames_to_measure(of_job, segment, neighbours_in(params));
  };
  MeasuredRun measured;
  const double begin = process_cpu_seconds();
  RenderObserver observer;
  observer.planned = [&](const RenderPlan& planned) {
    measured.setup_cpu_seconds = process_cpu_seconds() - begin;
    if (planned.join_bytes > 0.0) plan.join_bytes = planned.join_bytes;
  };
  const RenderReport report = render_animation(job_in(folder.path(), params), context, observer, run);
  measured.cpu_seconds = process_cpu_seconds() - begin;
  measured.frames = params.strips > 1 ? report.strips : report.frames, measured.sources = report.run.sources;
  measured.peak_memory_bytes = report.run.peak_memory_bytes;
  plan.costs = frame_costs(measured, parts, plan.segment);
  const std::vector<std::vector<int>> units = units_of(parts, plan.segment, count);
  for (std::size_t i = 0; i < units.size(); ++i)
    plan.units[i].cpu_seconds = cpu_seconds_of(units[i], plan.segment, *plan.costs);
  return plan;
}

}  // namespace

UnitPlan plan_units(const RenderParams& wanted, int count, bool measure, const Context& context) {
  const RenderParams params = with_scene_defaults(wanted);
  return measure ? measured_plan(params, count, context) : unmeasured_plan(params, count, context);
}

}  // namespace lippmann
