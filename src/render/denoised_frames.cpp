#include "render/denoised_frames.hpp"

#include "core/error.hpp"
#include "render/aov_params.hpp"
#include "render/frame_layout.hpp"
#include "trace/noisy_frame.hpp"

namespace lippmann {
namespace {

constexpr const char* kDenoiseFlag = "--denoise";

}  // namespace

void check_denoise(const RenderParams& params) {
  if (!params.denoise) return;
  if (integrator_of(params) != Integrator::kPath)
    throw usage_error(kDenoiseFlag, "only paths have noise", "--integrator path with it");
  if (samples_per_pixel(params) < 2)
    throw usage_error(kDenoiseFlag, "the noise of one sample cannot be told", "--spp of 2 or more with it");
}

DenoisedFrames::DenoisedFrames(Stage& stage, const RenderParams& params, const ThreadPool& pool, const Context& context)
    : stage_(stage),
      params_(params),
      pool_(pool),
      context_(context),
      denoiser_(stage.placed.optics, film_layout(stage.placed.optics, kDenoiseFlag)) {}

RenderedFrame DenoisedFrames::make(int frame) {
  while (!traced_.empty() && traced_.begin()->first < frame - 1) traced_.erase(traced_.begin());
  RenderedFrame rendered;
  const Traced* before = traced(frame - 1);
  Traced* now = traced(frame);
  const Traced* after = traced(frame + 1);
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
  const FrameClock clock(pool_);
  const Moment moment = stage_.moment_at(frame);
  stage_.device.update(moment.resolved, pool_);
  TraceParams trace = trace_params(params_, stage_.scene);
  trace.frame = static_cast<std::uint32_t>(frame);
  Traced made;
  made.aovs = wanted_aovs(params_);
  made.report.frame = frame;
  NoisyFrame noisy;
  const Optics& optics = stage_.placed.optics;
  made.report.rays =
      trace_noisy_frame(stage_.device, optics, moment.world_from_display, trace, pool_, context_, noisy, made.aovs);
  if (context_.cancelled) return nullptr;
  add_first_hits(stage_, params_, moment, frame, pool_, made.aovs);
  const Image motion = motion_from(moment, frame - 1), motion_after = motion_from(moment, frame + 1);
  made.ready = denoiser_.prepare({noisy.film, noisy.odd, noisy.seen, noisy.albedo, noisy.normal, noisy.z, noisy.met, motion,
                                  motion_after, trace.spp, inverse(moment.world_from_display).linear},
                                 pool_);
  clock.add_to(made.report);
  unused_[frame] = made.report;
  return &(traced_[frame] = std::move(made));
}

/// How far the points of the present frame have come since (or will have gone back until) another.
Image DenoisedFrames::motion_from(const Moment& now, int other) {
  FrameAovs aovs;
  aovs.want(Aov::kMotion);
  const int last = stage_.scene.timeline.frame_count - 1;
  const Moment then = stage_.moment_at(std::clamp(other, 0, last));
  const FrameStep step{now.resolved, then.resolved, then.world_from_display};
  find_first_hits(stage_.device, stage_.placed.optics, now.world_from_display, params_.order, &step, pool_, aovs);
  return std::move(aovs[Aov::kMotion]);
}

std::vector<FrameReport> DenoisedFrames::sources() const {
  std::vector<FrameReport> reports;
  for (const auto& [frame, report] : unused_) reports.push_back(report);
  return reports;
}

double DenoisedFrames::bytes_kept_per_pixel() {
  constexpr double kNoisyBytes = 84.0 + 16.0;  // images of a NoisyFrame, two of motion
  return 3.0 * Denoiser::kFrameBytesPerPixel + std::max(kNoisyBytes, Denoiser::kWorkBytesPerPixel);
}

}  // namespace lippmann
