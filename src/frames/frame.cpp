#include "frames/frame.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "trace/first_hits.hpp"

namespace lippmann {

namespace {

AngularFilter angular_filter(const Sampling& sampling, const PlacedOptics& placed) {
  const bool beams = placed.for_display && samples_per_pixel(sampling) > 1;
  return sampling.angular_filter.value_or(beams ? AngularFilter::kBox : AngularFilter::kNone);
}

}  // namespace

FrameAovs wanted_aovs(const Sampling& sampling) {
  FrameAovs aovs;
  for (const Aov aov : sampling.aov) aovs.want(aov);
  if (sampling.transparent) aovs.want(Aov::kAlpha);
  return aovs;
}

void set_provenance(Provenance all, Vec2i film_size, FrameAovs& aovs) {
  if (!aovs.wants(Aov::kProvenance)) return;
  aovs.allocate(Aov::kProvenance, film_size);
  std::vector<float>& codes = aovs[Aov::kProvenance].data;
  std::fill(codes.begin(), codes.end(), static_cast<float>(all));
}

void set_provenance(std::span<const std::uint8_t> of_pixels, Vec2i film_size, FrameAovs& aovs) {
  set_provenance(Provenance::kTraced, film_size, aovs);
  if (aovs.wants(Aov::kProvenance)) std::copy(of_pixels.begin(), of_pixels.end(), aovs[Aov::kProvenance].data.begin());
}

TraceParams trace_params(const Sampling& sampling, const Stage& stage) {
  TraceParams trace;
  trace.order = sampling.order;
  trace.spp = samples_per_pixel(sampling);
  trace.max_depth = sampling.max_depth > 0 ? sampling.max_depth : stage.scene.max_depth;
  trace.seed = sampling.seed;
  trace.angular_filter = angular_filter(sampling, stage.placed);
  trace.clamp_indirect = sampling.clamp_indirect;
  return trace;
}

Stage::Stage(Scene described, FittedArray fitted, PlacedOptics of_array, Integrator integrator, const ThreadPool& pool)
    : scene(std::move(described)), array(std::move(fitted)), placed(std::move(of_array)), device(scene, pool, integrator) {}

Moment Stage::moment_at(int frame) const {
  Moment moment{evaluate(scene, scene.timeline.time(frame)), {}};
  moment.world_from_display = world_from_display(array, placed.units_per_mm, moment.resolved);
  return moment;
}

void add_first_hits(const Stage& stage, const Sampling& sampling, const Moment& moment, int frame, const ThreadPool& pool,
                    FrameAovs& aovs) {
  std::optional<Moment> before;
  if (aovs.wants(Aov::kMotion) && frame > 0) before = stage.moment_at(frame - 1);
  std::optional<FrameStep> step;
  if (before) step.emplace(FrameStep{moment.resolved, before->resolved, before->world_from_display});
  find_first_hits(stage.shot(moment), sampling.order, step ? &*step : nullptr, pool, aovs);
}

RenderedFrame render_frame(Stage& stage, const Sampling& sampling, int frame, const ThreadPool& pool, const Context& context,
                           TouchedBlocks* touched) {
  const FrameClock clock(pool);
  const Moment moment = stage.moment_at(frame);
  stage.device.update(moment.resolved, pool);

  RenderedFrame rendered;
  rendered.pictures.aovs = wanted_aovs(sampling);
  set_provenance(Provenance::kTraced, film_size(stage.shot(moment)), rendered.pictures.aovs);
  rendered.report.frame = frame;
  TraceParams trace = trace_params(sampling, stage);
  trace.frame = static_cast<std::uint32_t>(frame);
  rendered.report.rays = trace_frame(stage.shot(moment), trace, {pool, context},
                                     {rendered.pictures.film, &rendered.pictures.aovs, nullptr, touched});
  if (!context.cancelled) add_first_hits(stage, sampling, moment, frame, pool, rendered.pictures.aovs);
  clock.add_to(rendered.report);
  return rendered;
}

}  // namespace lippmann
