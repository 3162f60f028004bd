#include "render/frame.hpp"

#include "render/panel_size.hpp"

namespace lippmann {

TraceParams trace_params(const RenderParams& params, const Scene& scene, int frame) {
  TraceParams trace;
  trace.order = params.order;
  trace.spp = params.spp;
  trace.max_depth = params.max_depth > 0 ? params.max_depth : scene.max_depth;
  trace.seed = params.seed;
  trace.frame = frame;
  return trace;
}

Stage::Stage(const RenderParams& params, const ThreadPool& pool, const Context& context)
    : scene(load_scene(params.scene, load_options(params), context)),
      array(fit_array(scene, window_aspect(params, scene.resolution))),
      placed(make_optics(params, scene, array)),
      device(scene, pool) {}

RenderedFrame render_frame(Stage& stage, const RenderParams& params, int frame, const ThreadPool& pool,
                           const Context& context) {
  const FrameClock clock(pool);
  const ResolvedScene resolved = evaluate(stage.scene, stage.scene.timeline.time(frame));
  stage.device.update(resolved, pool);
  const Affine3f world_from_array = world_from_display(stage.array, stage.placed.units_per_mm, resolved);

  RenderedFrame rendered;
  rendered.pictures.aovs = wanted_aovs(params);
  rendered.report.frame = frame;
  rendered.report.rays =
      trace_frame(stage.device, stage.placed.optics, world_from_array, trace_params(params, stage.scene, frame), pool, context,
                  rendered.pictures.film, params.aov.empty() ? nullptr : &rendered.pictures.aovs);
  clock.add_to(rendered.report);
  return rendered;
}

}  // namespace lippmann
