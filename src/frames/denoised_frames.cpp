#include "frames/denoised_frames.hpp"

#include <algorithm>

#include "layout/film_layout.hpp"
#include "trace/first_hits.hpp"
#include "trace/noisy_frame.hpp"

namespace lippmann {
DenoisedFrames::DenoisedFrames(Stage& stage, const Sampling& sampling, const ShareLight* light, const ThreadPool& pool,
                               const Context& context)
    : stage_(stage),
      sampling_(sampling),
      pool_(pool),
      context_(context),
      denoiser_(stage.placed.optics, film_layout(stage.placed.optics, "denoise")) {
  if (light) lit_.emplace(stage, sampling, *light, pool, context);
}

RenderedFrame DenoisedFrames::make(int frame) {
  while (!traced_.empty() && traced_.begin()->first < frame - 1) traced_.erase(traced_.begin());
  RenderedFrame rendered;
  const auto neighbour = [&](int other) {
    return lit_ && !SharedLightFrames::are_of_one_history(frame, other) ? nullptr : traced(other);
  };
  const Traced* before = neighbour(frame - 1);
  Traced* now = traced(frame);
  const Traced* after = neighbour(frame + 1);
  if (context_.cancelled) return rendered;
  rendered.report = now->report;
  unused_.erase(frame);
  const FrameClock clock(pool_);
  rendered.pictures.film =
      denoiser_.denoise(before ? before->ready.get() : nullptr, *now->ready, after ? after->ready.get() : nullptr, pool_);
  rendered.pictures.aovs = std::move(now->aovs);
  clock.add_to(rendered.report);
  return rendered;
}

DenoisedFrames::Traced* DenoisedFrames::traced(int frame) {
  if (frame < 0 || frame >= stage_.scene.timeline.frame_count || context_.cancelled) return nullptr;
  if (const auto found = traced_.find(frame); found != traced_.end()) return &found->second;
  const Moment moment = stage_.moment_at(frame);
  Traced made;
  NoisyFrame noisy;
  made.report = trace(frame, moment, made, noisy);
  if (context_.cancelled) return nullptr;
  const FrameClock clock(pool_);
  add_first_hits(stage_, sampling_, moment, frame, pool_, made.aovs);
  const Image motion = motion_from(moment, frame - 1), motion_after = motion_from(moment, frame + 1);
  made.ready = denoiser_.prepare({noisy.film, noisy.noise, noisy.seen, noisy.albedo, noisy.normal, noisy.z, noisy.met, motion,
                                  motion_after, inverse(moment.world_from_display).linear},
                                 pool_);
  clock.add_to(made.report);
  unused_[frame] = made.report;
  return &(traced_[frame] = std::move(made));
}

/// The frame with its noise, and its layers.
FrameReport DenoisedFrames::trace(int frame, const Moment& moment, Traced& made, NoisyFrame& noisy) {
  FramePictures pictures;
  pictures.aovs = wanted_aovs(sampling_);
  FrameReport report;
  if (lit_) {
    report = lit_->make_noisy(frame, pictures, noisy);
    noisy.film = std::move(pictures.film);
  } else {
    const FrameClock clock(pool_);
    stage_.device.update(moment.resolved, pool_);
    set_provenance(Provenance::kTraced, film_size(stage_.shot(moment)), pictures.aovs);
    TraceParams trace = trace_params(sampling_, stage_);
    trace.frame = static_cast<std::uint32_t>(frame);
    report.frame = frame;
    report.rays = trace_noisy_frame(stage_.shot(moment), trace, {pool_, context_}, noisy, pictures.aovs);
    clock.add_to(report);
  }
  made.aovs = std::move(pictures.aovs);
  return report;
}

/// How far the points of the present frame have come since (or will have gone back until) another.
Image DenoisedFrames::motion_from(const Moment& now, int other) {
  FrameAovs aovs;
  aovs.want(Aov::kMotion);
  const int last = stage_.scene.timeline.frame_count - 1;
  const Moment then = stage_.moment_at(std::clamp(other, 0, last));
  const FrameStep step{now.resolved, then.resolved, then.world_from_display};
  find_first_hits(stage_.shot(now), sampling_.order, &step, pool_, aovs);
  return std::move(aovs[Aov::kMotion]);
}

std::vector<FrameReport> DenoisedFrames::sources() const {
  std::vector<FrameReport> reports = lit_ ? lit_->sources() : std::vector<FrameReport>{};
  for (const auto& [frame, report] : unused_) reports.push_back(report);
  std::sort(reports.begin(), reports.end(), [](const FrameReport& a, const FrameReport& b) { return a.frame < b.frame; });
  return reports;
}

double DenoisedFrames::bytes_per_pixel(const Workload& work) {
  const double neighbours = work.frames > 1 ? 3.0 : 2.5;  // a single frame has two of them, or one at an animation's end
  return std::min<double>(neighbours, work.animation_frames) * Denoiser::kFrameBytesPerPixel + Denoiser::kWorkBytesPerPixel;
}

}  // namespace lippmann
