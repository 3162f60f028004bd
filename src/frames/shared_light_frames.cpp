#include "frames/shared_light_frames.hpp"

#include <algorithm>
#include <cmath>

#include "lippmann/image/metrics.hpp"

namespace lippmann {
namespace {

/// Frames that share what they find. Each such segment begins anew, whoever renders it: any split of an animation, and any
/// resume, gives the same pictures.
constexpr int kSegment = 16;

/// What a measured error exceeds in one of twenty cases: 1.645 standard deviations above it. They are the logarithm's: an error
/// that few pixels make is measured too small more often than too large.
double upper_bound(const PixelError& error) {
  constexpr double kOneSided = 1.645;
  const auto squared_error = static_cast<double>(error.squared), deviation = static_cast<double>(error.uncertainty);
  return squared_error > 0.0 ? squared_error * std::exp(kOneSided * deviation / squared_error) : kOneSided * deviation;
}

/// The PSNR of a mean squared error of codes from 0 to 1.
double psnr_of(double squared_error) { return psnr_db(255.0 * 255.0 * squared_error); }

/// The kind and the errors of a frame; whole paths are measured, too.
void tell_errors(const CachedLightReport& light, FrameReport& report) {
  if (!light.traced) report.kind = "shared";
  report.estimated_psnr_db = psnr_of(static_cast<double>(light.pixels.squared));
  report.psnr_at_least_db = psnr_of(upper_bound(light.pixels));
  report.estimated_psnr_at_eye_db = psnr_of(static_cast<double>(light.at_eye.squared));
  report.psnr_at_eye_at_least_db = psnr_of(upper_bound(light.at_eye));
  report.estimated_block_psnr_db = psnr_of(light.block_squared_error);
}

}  // namespace

SharedLightFrames::SharedLightFrames(Stage& stage, const Sampling& sampling, const ShareLight& reuse, const ThreadPool& pool,
                                     const Context& context, LightHistory history)
    : stage_(stage),
      sampling_(sampling),
      reuse_(reuse),
      pool_(pool),
      context_(context),
      swept_(stage.scene, -1),
      tracer_(stage.device),
      segment_(stage.rows == FilmRows{} && history == LightHistory::kSegment ? kSegment : 1) {}

RenderedFrame SharedLightFrames::make(int frame) {
  RenderedFrame rendered;
  rendered.pictures.aovs = wanted_aovs(sampling_);
  go_to(frame, rendered.pictures);
  rendered.report = visit(frame, rendered.pictures);
  const FrameClock clock(pool_);
  if (!context_.cancelled) add_first_hits(stage_, sampling_, stage_.moment_at(frame), frame, pool_, rendered.pictures.aovs);
  clock.add_to(rendered.report);
  return rendered;
}

FrameReport SharedLightFrames::make_noisy(int frame, FramePictures& pictures, NoisyFrame& noisy) {
  go_to(frame, pictures);
  return visit(frame, pictures, &noisy);
}

int SharedLightFrames::frames_per_segment() { return kSegment; }

bool SharedLightFrames::are_of_one_history(int frame, int other) { return frame / kSegment == other / kSegment; }

/// Visits what comes before a frame in its history and has not been visited yet.
void SharedLightFrames::go_to(int frame, FramePictures& pictures) {
  const int start = frame / segment_ * segment_;
  if (next_ < start || next_ > frame) next_ = start;
  while (next_ < frame && !context_.cancelled) sources_.push_back(visit(next_, pictures));
}

FrameReport SharedLightFrames::visit(int frame, FramePictures& pictures, NoisyFrame* noisy) {
  const FrameClock clock(pool_);
  if (frame % segment_ == 0) tracer_.restart();
  const Moment moment = stage_.moment_at(frame);
  stage_.device.update(moment.resolved, pool_);
  TraceParams trace = trace_params(sampling_, stage_);
  trace.frame = static_cast<std::uint32_t>(frame);
  CachedLightGoal goal;
  goal.error.crosstalk_px = reuse_.crosstalk_px, goal.error.at_eye = reuse_.quality_at == QualityAt::kEye;
  if (reuse_.min_psnr_db) goal.error.squared = static_cast<float>(std::pow(10.0, -0.1 * *reuse_.min_psnr_db));
  goal.seconds = reuse_.time_budget_s;
  goal.frames = std::min(segment_, stage_.scene.timeline.frame_count - frame / segment_ * segment_);
  goal.provenance = reuse_.show_provenance;
  constexpr int kTwoFrames[] = {2};
  const std::vector<HorizonBox> moving =
      frame % segment_ > 0 ? swept_.around(frame - 1, kTwoFrames, frame) : std::vector<HorizonBox>{};
  const CachedLightReport light = tracer_.trace(stage_.shot(moment), moment.resolved, trace, goal, moving, {pool_, context_},
                                                {pictures.film, &pictures.aovs, noisy});
  next_ = frame + 1;
  FrameReport report;
  report.frame = frame;
  report.rays = light.rays;
  tell_errors(light, report);
  clock.add_to(report);
  return report;
}

}  // namespace lippmann
