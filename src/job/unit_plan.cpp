#include "job/unit_plan.hpp"

#include <utility>
#include <variant>

#include "core/platform.hpp"
#include "core/scratch_folder.hpp"
#include "distribute/units.hpp"
#include "frames/frame_maker.hpp"
#include "frames/strip_maker.hpp"
#include "job/animation.hpp"
#include "job/job_folder.hpp"
#include "job/job_scene.hpp"
#include "job/placed_job.hpp"
#include "job/render_setup.hpp"
#include "job/reuse_params.hpp"

namespace lippmann {
namespace {

/// Divides `parts` into `count` units without estimating their costs. A part is a frame or, if `strips` > 1, one of the
/// `strips` strips of a frame. `segment`: number of successive frames that must be in the same unit.
UnitPlan cut(const std::vector<int>& parts, int strips, int segment, int count) {
  UnitPlan plan;
  plan.segment = segment;
  for (const std::vector<int>& unit : units_of(parts, segment, count)) {
    plan.units.push_back({frames_of_parts(unit, strips)});
    if (strips > 1) plan.units.back().strips = strips_of_parts(unit, strips);
  }
  return plan;
}

UnitPlan unmeasured_plan(const ResolvedJob& job, int count, const Context& context) {
  const FrameParams frame_settings = frame_params(job);
  const JobScene loaded = load_scene_of(job, context);
  const PlacedJob placed_job = place(job, loaded.scene);
  const int strips = job.params().strips;
  if (job.is_in_strips()) check_strips(frame_settings, placed_job.placed.optics, strips);
  return cut(parts_of(frames_of_job(job.params(), loaded.scene.timeline), strips), strips, segment_of(job, frame_settings),
             count);
}

ResolvedJob job_in(const std::filesystem::path& folder, const ResolvedJob& job) {
  RenderParams params = job.params();
  params.output.folder = folder.string();
  params.output.video.clear();
  params.resume = false;
  return ResolvedJob(std::move(params));
}

Neighbours neighbours_in(const ResolvedJob& job, const FrameParams& frame_settings) {
  if (job.is_in_strips()) return Neighbours::kOthers;
  return std::holds_alternative<CopySettled>(frame_settings.reuse) ? Neighbours::kCopied : Neighbours::kOthers;
}

/// Divides the job into `count` units, and estimates their costs from the times that a few rendered frames take.
UnitPlan measured_plan(const ResolvedJob& job, int count, const Context& context) {
  const double begin = platform::process_cpu_seconds();
  const FrameParams frame_settings = frame_params(job);
  const int strips = job.params().strips, segment = segment_of(job, frame_settings);
  JobScene loaded = load_scene_of(job, context);
  const std::vector<int> parts = parts_of(frames_of_job(job.params(), loaded.scene.timeline), strips);
  UnitPlan plan = cut(parts, strips, segment, count);
  RunParams run;
  run.parts = frames_to_measure(parts, segment, neighbours_in(job, frame_settings));
  const ScratchFolder folder;
  RenderSetup setup(job_in(folder.path(), job), run, context, std::move(loaded));
  if (setup.join_bytes > 0.0) plan.join_bytes = setup.join_bytes;
  MeasuredRun measured;
  measured.setup_cpu_seconds = platform::process_cpu_seconds() - begin;
  const RenderReport report = render_animation(setup, context);
  measured.cpu_seconds = platform::process_cpu_seconds() - begin;
  measured.frames = job.is_in_strips() ? report.strips : report.frames, measured.sources = report.run.sources;
  measured.peak_memory_bytes = report.run.peak_memory_bytes;
  plan.costs = frame_costs(measured, parts, segment);
  const std::vector<std::vector<int>> units = units_of(parts, segment, count);
  for (std::size_t i = 0; i < units.size(); ++i) plan.units[i].cpu_seconds = cpu_seconds_of(units[i], segment, *plan.costs);
  return plan;
}

}  // namespace

UnitPlan plan_units(const ResolvedJob& job, int count, bool measure, const Context& context) {
  return measure ? measured_plan(job, count, context) : unmeasured_plan(job, count, context);
}

}  // namespace lippmann
