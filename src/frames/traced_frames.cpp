#include "frames/traced_frames.hpp"

#include "frames/audit.hpp"
#include "trace/noisy_frame.hpp"

namespace lippmann {

TracedFrames::TracedFrames(Stage& stage, const Sampling& sampling, const ThreadPool& pool, const Context& context)
    : stage_(stage), sampling_(sampling), pool_(pool), context_(context) {
  if (is_denoised(sampling)) denoiser_.emplace(stage.placed.optics);
}

RenderedFrame TracedFrames::make(int frame) {
  RenderedFrame rendered = denoiser_ ? denoised(frame) : render_frame(stage_, sampling_, frame, pool_, context_);
  if (integrator_of(sampling_) == Integrator::kPath && !context_.cancelled)
    audit(stage_, sampling_, frame, rendered.pictures.film, pool_, context_, rendered.report);
  return rendered;
}

RenderedFrame TracedFrames::denoised(int frame) {
  NoisyFrame noisy;
  RenderedFrame rendered = render_noisy_frame(stage_, sampling_, frame, pool_, context_, noisy);
  if (context_.cancelled) return rendered;
  const FrameClock clock(pool_);
  const Mat3f display_from_world = inverse(stage_.moment_at(frame).world_from_display).linear;
  rendered.pictures.film = denoiser_->denoise(
      {noisy.film, noisy.noise, noisy.seen, noisy.albedo, noisy.normal, noisy.z, noisy.met, display_from_world}, pool_);
  clock.add_to(rendered.report);
  return rendered;
}

double TracedFrames::bytes_per_pixel(const Sampling& sampling) {
  return is_denoised(sampling) ? kNoisyFrameBytesPerPixel + Denoiser::kWorkBytesPerPixel : 0.0;
}

}  // namespace lippmann
