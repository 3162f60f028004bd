#include "render/frame.hpp"

#include "render/display_optics.hpp"

namespace lippmann {

TraceParams trace_params(const RenderParams& params, const Scene& scene) {
  TraceParams trace;
  trace.order = params.order;
  trace.spp = params.spp;
  trace.max_depth = params.max_depth > 0 ? params.max_depth : scene.max_depth;
  trace.seed = params.seed;
  return trace;
}

Stage::Stage(const RenderParams& params, const ThreadPool& pool, const Context& context)
    : display(wanted_display(params)),
      scene(wanted_scene(params, context)),
      array(fit_array(scene, window_aspect(params, scene.resolution, display.get()))),
      placed(make_optics(params, scene, array, display.get())),
      device(scene, pool) {}

Moment Stage::moment_at(int frame) const {
  Moment moment{evaluate(scene, scene.timeline.time(frame)), {}};
  moment.world_from_display = world_from_display(array, placed.units_per_mm, moment.resolved);
  return moment;
}

RenderedFrame render_frame(Stage& stage, const RenderParams& params, int frame, const ThreadPool& pool, const Context& context,
                           TouchedBlocks* touched) {
  const FrameClock clock(pool);
  const Moment moment = stage.moment_at(frame);
  stage.device.update(moment.resolved, pool);

  RenderedFrame rendered;
  rendered.pictures.aovs = wanted_aovs(params);
  rendered.report.frame = frame;
  rendered.report.rays =
      trace_frame(stage.device, stage.placed.optics, moment.world_from_display, trace_params(params, stage.scene), pool,
                  context, rendered.pictures.film, params.aov.empty() ? nullptr : &rendered.pictures.aovs, nullptr, touched);
  clock.add_to(rendered.report);
  return rendered;
}

}  // namespace lippmann
