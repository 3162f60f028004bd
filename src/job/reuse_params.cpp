#include "job/reuse_params.hpp"

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

/// The first flag that only interpolation knows and that is not as it is by default; empty if there is none.
std::string interpolation_flag(const ReuseParams& said) {
  const ReuseParams defaults;
  if (said.splat != defaults.splat) return "--splat";
  if (said.fill != defaults.fill) return "--fill";
  if (said.halving) return "--halving";
  if (said.no_z_buffer) return "--no-z-buffer";
  return said.debug == DebugPicture::kMissed ? "--debug" : "";
}

void refuse_interpolation_flags(const ReuseParams& said) {
  if (const std::string stray = interpolation_flag(said); !stray.empty())
    throw usage_error(stray, "means nothing without interpolated frames", "it together with --reuse interpolate");
}

void refuse_light_flags(const ReuseParams& said) {
  constexpr const char* kAccepted = "--integrator path --reuse light with it, 8 --spp or more, and no --aov direct or indirect";
  if (said.time_budget_s) throw usage_error("--time-budget", "is for path-traced frames that share light", kAccepted);
  if (said.debug == DebugPicture::kProvenance)
    throw usage_error("--debug", "provenance shows where shared light came from, and none is", kAccepted);
}

TraceAll trace_all(const ReuseParams& said) {
  refuse_interpolation_flags(said);
  refuse_light_flags(said);
  if (said.keyframes)
    throw usage_error("--keyframes", "means nothing where every frame is traced",
                      "it together with --reuse copy or interpolate");
  if (said.min_psnr_db)
    throw usage_error("--min-psnr", "means nothing where every frame is traced",
                      "it together with --reuse interpolate, or light with --integrator path");
  return {};
}

CopySettled copy_settled(const ReuseParams& said) {
  refuse_interpolation_flags(said);
  refuse_light_flags(said);
  return {said.keyframes};
}

ShareLight share_light(const ReuseParams& said) {
  refuse_interpolation_flags(said);
  if (said.keyframes)
    throw usage_error("--keyframes", "means nothing where frames share light", "it together with --reuse copy or interpolate");
  return {said.min_psnr_db, said.time_budget_s, said.debug == DebugPicture::kProvenance};
}

Interpolate interpolate(const ReuseParams& said) {
  refuse_light_flags(said);
  const bool shows_missed = said.debug == DebugPicture::kMissed;
  if (shows_missed && said.fill == MissedFill::kRetrace)
    throw usage_error("--fill", "retraced pixels would not be seen: --debug missed leaves them black", "one of the two");
  if (shows_missed && said.min_psnr_db)
    throw usage_error("--debug", "cannot be together with --min-psnr, which traces what is missed or doubted",
                      "one of the two");
  return {said.keyframes, said.min_psnr_db, said.splat, shows_missed ? MissedFill::kBlack : said.fill,
          said.halving,   said.no_z_buffer};
}

/// What is said of key frames and floors holds for any scene, as jobs for many scenes say it: frames that share light have no
/// key frames, and pixels that are copied or traced keep to any floor.
Reuse reuse_by_sampling(ReuseParams said, const Sampling& sampling) {
  if (can_copy_settled(sampling)) return copy_settled(said);
  said.keyframes.reset();
  if (can_share_light(sampling, {said.min_psnr_db, said.time_budget_s})) return share_light(said);
  if (integrator_of(sampling) == Integrator::kWhitted) said.min_psnr_db.reset();
  return trace_all(said);
}

Reuse wanted_reuse(const ReuseParams& said, const Sampling& sampling) {
  switch (said.choice) {
    case ReuseChoice::kAuto:
      return reuse_by_sampling(said, sampling);
    case ReuseChoice::kNone:
      return trace_all(said);
    case ReuseChoice::kCopy:
      return copy_settled(said);
    case ReuseChoice::kLight:
      return share_light(said);
    case ReuseChoice::kInterpolate:
      break;
  }
  return interpolate(said);
}

}  // namespace

FrameParams frame_params(const RenderParams& params) {
  FrameParams frames{params.sampling, wanted_reuse(params.reuse, params.sampling)};
  check(frames);
  return frames;
}

void check_floor(const RenderParams& params) {
  if (params.reuse.min_psnr_db && !tone_of(params.output.pictures).is_identity())
    throw usage_error("--min-psnr", "is a floor for pictures that show light as it is", "no --exposure and --tone with it");
}

std::string whole_paths_sentence(const RenderParams& params) {
  Sampling without_layers = params.sampling;
  without_layers.aov.clear();
  if (params.reuse.choice != ReuseChoice::kAuto || can_share_light(params.sampling) || !can_share_light(without_layers))
    return "";
  return "--aov direct and indirect are parts of whole paths: no light is shared";
}

}  // namespace lippmann
