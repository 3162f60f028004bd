#include "job/reuse_params.hpp"

#include "lippmann/core/error.hpp"
#include "optics/optics_kind.hpp"

namespace lippmann {
namespace {

/// Returns the first flag of interpolation that differs from its default, or an empty string.
std::string interpolation_flag(const ReuseParams& params) {
  const ReuseParams defaults;
  if (params.splat != defaults.splat) return "--splat";
  if (params.fill != defaults.fill) return "--fill";
  if (params.halving) return "--halving";
  if (params.no_z_buffer) return "--no-z-buffer";
  return params.debug == DebugPicture::kMissed ? "--debug" : "";
}

void refuse_interpolation_flags(const ReuseParams& params) {
  if (const std::string stray = interpolation_flag(params); !stray.empty())
    throw usage_error(stray, "has no effect without interpolated frames", "--reuse interpolate");
}

TraceAll trace_all(const ReuseParams& params) {
  refuse_interpolation_flags(params);
  if (params.keyframes)
    throw usage_error("--keyframes", "has no effect where every frame is traced in full", "--reuse copy or interpolate");
  if (params.min_psnr_db)
    throw usage_error("--min-psnr", "has no effect where every frame is traced in full",
                      "--reuse interpolate; for path tracing, --spp in place of --min-psnr");
  return {};
}

CopySettled copy_settled(const ReuseParams& params) {
  refuse_interpolation_flags(params);
  return {params.keyframes};
}

Interpolate interpolate(const ReuseParams& params) {
  const bool shows_missed = params.debug == DebugPicture::kMissed;
  if (shows_missed && params.fill == MissedFill::kRetrace)
    throw usage_error("--fill", "retrace cannot be combined with --debug missed, which leaves missed pixels black",
                      "one of the two");
  if (shows_missed && params.min_psnr_db)
    throw usage_error("--debug", "cannot be combined with --min-psnr, which traces missing and uncertain pixels",
                      "one of the two");
  return {params.keyframes, params.min_psnr_db, params.splat, shows_missed ? MissedFill::kBlack : params.fill,
          params.halving,   params.no_z_buffer};
}

/// Returns the kind of reuse that kAuto stands for. --keyframes is ignored if no frame can be copied, and --min-psnr if
/// pixels are copied or traced without noise, so that the same flags work for many scenes.
Reuse reuse_by_sampling(ReuseParams params, const Sampling& sampling) {
  if (can_copy_settled(sampling)) return copy_settled(params);
  params.keyframes.reset();
  if (!facts_of(sampling).is_stochastic) params.min_psnr_db.reset();
  return trace_all(params);
}

Reuse wanted_reuse(const ReuseParams& params, const Sampling& sampling) {
  switch (params.choice) {
    case ReuseChoice::kAuto:
      return reuse_by_sampling(params, sampling);
    case ReuseChoice::kNone:
      return trace_all(params);
    case ReuseChoice::kCopy:
      return copy_settled(params);
    case ReuseChoice::kInterpolate:
      break;
  }
  return interpolate(params);
}

}  // namespace

FrameParams frame_params(const ResolvedJob& job) {
  FrameParams frames{job.sampling(), wanted_reuse(job.params().reuse, job.sampling())};
  // Rays of camera optics already pass through a lens.
  if (optics_kind(job.params()).info().is_camera) frames.sampling.lens.f_number = 0.0f;
  check(frames);
  return frames;
}

void check_floor(const RenderParams& params) {
  if (params.reuse.min_psnr_db && !tone_of(params.output.pictures).is_identity())
    throw usage_error("--min-psnr", "cannot be combined with --exposure or --tone", "--min-psnr without --exposure and --tone");
}

}  // namespace lippmann
