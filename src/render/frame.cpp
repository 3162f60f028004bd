#include "render/frame.hpp"

#include <optional>
#include <utility>

#include "lippmann/core/error.hpp"
#include "render/aov_params.hpp"
#include "render/display_optics.hpp"
#include "trace/first_hits.hpp"

namespace lippmann {

AngularFilter wanted_angular_filter(const FrameParams& params, const PlacedOptics& placed) {
  if (params.sampling.angular_filter) return *params.sampling.angular_filter;
  return placed.for_display && samples_per_pixel(params) > 1 && params.reuse.mode != Reuse::kForward ? AngularFilter::kBox
                                                                                                     : AngularFilter::kNone;
}

void check_angular_filter(const FrameParams& params, const Optics& optics) {
  constexpr const char* kFlag = "--angular-filter";
  if (params.sampling.angular_filter != AngularFilter::kBox) return;
  if (!std::holds_alternative<MultiView>(optics.model))
    throw usage_error(kFlag,
                      "only views have eyes to be spread: below lenses, the samples of a pixel are seen from all of its "
                      "directions anyway",
                      "--optics multiview, or --spp alone");
  if (samples_per_pixel(params) == 1) throw usage_error(kFlag, "one sample is seen from one eye", "--spp of 2 or more with it");
  if (params.reuse.mode == Reuse::kForward)
    throw usage_error(kFlag, "points that are moved by --reuse forward are those of one eye", "--reuse exact or none");
}

TraceParams trace_params(const FrameParams& params, const Stage& stage) {
  TraceParams trace;
  trace.order = params.sampling.order;
  trace.spp = samples_per_pixel(params);
  trace.max_depth = params.sampling.max_depth > 0 ? params.sampling.max_depth : stage.scene.max_depth;
  trace.seed = params.sampling.seed;
  trace.angular_filter = wanted_angular_filter(params, stage.placed);
  trace.clamp_indirect = params.sampling.clamp_indirect;
  return trace;
}

Stage::Stage(const RenderParams& params, const ThreadPool& pool, const Context& context)
    : Stage(SceneNotes{}, params, pool, context) {}

Stage::Stage(SceneNotes notes, const RenderParams& params, const ThreadPool& pool, const Context& context)
    : Stage(wanted_scene(params, context, &notes), params, pool) {
  light = std::move(notes.light);
}

Stage::Stage(Scene described, const RenderParams& params, const ThreadPool& pool)
    : display(wanted_display(params)),
      scene(std::move(described)),
      array(fit_array(scene, window_aspect(params, scene.resolution, display.get()), params.scene.view)),
      placed(make_optics(params, scene, array, display.get())),
      device(scene, pool, integrator_of(params)) {}

Stage::Stage(Scene described, FittedArray fitted, PlacedOptics of_array, Integrator integrator, const ThreadPool& pool)
    : scene(std::move(described)), array(std::move(fitted)), placed(std::move(of_array)), device(scene, pool, integrator) {}

Moment Stage::moment_at(int frame) const {
  Moment moment{evaluate(scene, scene.timeline.time(frame)), {}};
  moment.world_from_display = world_from_display(array, placed.units_per_mm, moment.resolved);
  return moment;
}

void add_first_hits(const Stage& stage, const FrameParams& params, const Moment& moment, int frame, const ThreadPool& pool,
                    FrameAovs& aovs) {
  std::optional<Moment> before;
  if (aovs.wants(Aov::kMotion) && frame > 0) before = stage.moment_at(frame - 1);
  std::optional<FrameStep> step;
  if (before) step.emplace(FrameStep{moment.resolved, before->resolved, before->world_from_display});
  find_first_hits(stage.device, stage.placed.optics, moment.world_from_display, params.sampling.order, step ? &*step : nullptr,
                  pool, aovs);
}

RenderedFrame render_frame(Stage& stage, const FrameParams& params, int frame, const ThreadPool& pool, const Context& context,
                           TouchedBlocks* touched) {
  const FrameClock clock(pool);
  const Moment moment = stage.moment_at(frame);
  stage.device.update(moment.resolved, pool);

  RenderedFrame rendered;
  rendered.pictures.aovs = wanted_aovs(params);
  rendered.report.frame = frame;
  TraceParams trace = trace_params(params, stage);
  trace.frame = static_cast<std::uint32_t>(frame);
  rendered.report.rays = trace_frame(stage.device, stage.placed.optics, moment.world_from_display, trace, pool, context,
                                     rendered.pictures.film, &rendered.pictures.aovs, nullptr, touched);
  if (!context.cancelled) add_first_hits(stage, params, moment, frame, pool, rendered.pictures.aovs);
  clock.add_to(rendered.report);
  return rendered;
}

}  // namespace lippmann
