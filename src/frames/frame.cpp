#include "frames/frame.hpp"

#include <algorithm>
#include <functional>
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
  trace.lens = lens_by_aperture(sampling.lens, stage.placed.optics, stage.placed.units_per_mm);
  trace.clamp_indirect = sampling.clamp_indirect;
  return trace;
}

Stage::Stage(Scene described, FittedArray fitted, PlacedOptics of_array, Integrator integrator, const ThreadPool& pool)
    : scene(std::move(described)), array(std::move(fitted)), placed(std::move(of_array)), device(scene, pool, integrator) {}

Moment Stage::moment_at(int frame) const { return moment_at_time(scene.timeline.time(frame)); }

Moment Stage::moment_at_time(double seconds) const {
  Moment moment{evaluate(scene, seconds), {}};
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

namespace {

/// Highest number of times at which a frame with motion blur is exposed. More have no visible effect.
constexpr int kMostTimes = 32;

using TraceShare = std::function<RayCounts(const Shot&, const TraceParams&, SampleShare, FramePictures&)>;

RayCounts trace_exposure(Stage& stage, const std::vector<ExposureTime>& times, const TraceParams& params,
                         const Workers& workers, const TraceShare& trace, FramePictures& pictures) {
  RayCounts rays;
  for (const ExposureTime& time : times) {
    if (workers.context.cancelled) break;
    const Moment moment = stage.moment_at_time(time.seconds);
    stage.device.update(moment.resolved, workers.pool);
    add(trace(stage.shot(moment), params, time.share, pictures), rays);
  }
  return rays;
}

RenderedFrame render_with(Stage& stage, const Sampling& sampling, int frame, const Workers& workers, const TraceShare& trace) {
  const FrameClock clock(workers.pool);
  const Moment moment = stage.moment_at(frame);
  stage.device.update(moment.resolved, workers.pool);

  RenderedFrame rendered;
  rendered.pictures.aovs = wanted_aovs(sampling);
  set_provenance(Provenance::kTraced, film_size(stage.shot(moment)), rendered.pictures.aovs);
  rendered.report.frame = frame;
  TraceParams params = trace_params(sampling, stage);
  params.frame = static_cast<std::uint32_t>(frame);
  if (sampling.shutter > 0.0f) {
    const std::vector<ExposureTime> times = exposure_times(sampling, stage.scene.timeline, frame);
    rendered.report.rays = trace_exposure(stage, times, params, workers, trace, rendered.pictures);
    // Layers of first hits are not blurred. They show the scene at the frame's own time.
    stage.device.update(moment.resolved, workers.pool);
  } else {
    rendered.report.rays = trace(stage.shot(moment), params, {}, rendered.pictures);
  }
  if (!workers.context.cancelled) add_first_hits(stage, sampling, moment, frame, workers.pool, rendered.pictures.aovs);
  clock.add_to(rendered.report);
  return rendered;
}

}  // namespace

std::vector<ExposureTime> exposure_times(const Sampling& sampling, const Timeline& timeline, int frame) {
  const int spp = samples_per_pixel(sampling), count = std::min(spp, kMostTimes);
  std::vector<ExposureTime> times;
  int samples_before = 0;
  for (int i = 0; i < count; ++i) {
    const int samples = (spp - i + count - 1) / count;
    const double middle = (samples_before + 0.5 * samples) / spp - 0.5;
    times.push_back(
        {timeline.time(frame) + static_cast<double>(sampling.shutter) * middle / timeline.frames_per_second, {i, count}});
    samples_before += samples;
  }
  return times;
}

RenderedFrame render_frame(Stage& stage, const Sampling& sampling, int frame, const ThreadPool& pool, const Context& context,
                           TouchedBlocks* touched) {
  const Workers workers{pool, context};
  return render_with(stage, sampling, frame, workers,
                     [&](const Shot& shot, const TraceParams& params, SampleShare share, FramePictures& pictures) {
                       return trace_frame(shot, params, workers, {pictures.film, &pictures.aovs, nullptr, touched}, share);
                     });
}

RenderedFrame render_noisy_frame(Stage& stage, const Sampling& sampling, int frame, const ThreadPool& pool,
                                 const Context& context, NoisyFrame& noisy) {
  const Workers workers{pool, context};
  return render_with(stage, sampling, frame, workers,
                     [&](const Shot& shot, const TraceParams& params, SampleShare share, FramePictures& pictures) {
                       return trace_noisy_frame(shot, params, workers, noisy, pictures.aovs, share);
                     });
}

}  // namespace lippmann
