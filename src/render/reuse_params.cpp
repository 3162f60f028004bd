#include "render/reuse_params.hpp"

#include <string>

#include "lippmann/core/error.hpp"
#include "render/lit_frames.hpp"

namespace lippmann {
namespace {

/// The first flag that only reuse forward knows and that is not as it is by default; empty if there is none.
std::string forward_only_flag(const FrameParams& params) {
  const FrameParams defaults;
  if (params.reuse.splat != defaults.reuse.splat) return "--splat";
  if (params.reuse.fill != defaults.reuse.fill) return "--fill";
  if (params.reuse.halving) return "--halving";
  if (params.reuse.no_z_buffer) return "--no-z-buffer";
  if (params.reuse.debug == DebugPicture::kMissed) return "--debug";
  return "";
}

/// The first flag that would take from a frame what its floor promises; empty if there is none.
std::string flag_against_floor(const FrameParams& params) {
  const FrameParams defaults;
  if (params.reuse.fill != defaults.reuse.fill) return "--fill";
  if (params.reuse.halving) return "--halving";
  if (params.reuse.no_z_buffer) return "--no-z-buffer";
  if (params.reuse.debug != defaults.reuse.debug) return "--debug";
  return "";
}

}  // namespace

void check_reuse(const FrameParams& params) {
  const std::string stray = forward_only_flag(params);
  if (params.reuse.mode != Reuse::kForward && !stray.empty())
    throw usage_error(stray, "means nothing without interpolated frames", "it together with --reuse forward");
  if (params.reuse.debug == DebugPicture::kProvenance && (params.sampling.denoise || !LitFrames::serves(params)))
    throw usage_error("--debug", "provenance shows where reused light came from, and none is",
                      "--integrator path --reuse exact with it, 8 --spp or more, no --denoise and no --aov direct or indirect");
  if (params.reuse.mode == Reuse::kNone && params.reuse.keyframes)
    throw usage_error("--keyframes", "means nothing where every frame is traced", "it together with --reuse exact or forward");
  if (params.reuse.mode == Reuse::kForward && integrator_of(params) == Integrator::kPath)
    throw usage_error("--reuse", "forward does not know path-traced frames", "none or exact, or --integrator whitted");
  if (params.reuse.time_budget_s && !LitFrames::serves(params))
    throw usage_error("--time-budget", "is for path-traced frames that share light",
                      "--integrator path --reuse exact with it, and no --aov direct or indirect");
  if (params.reuse.time_budget_s && params.reuse.min_psnr_db)
    throw usage_error("--time-budget", "and --min-psnr both say how good frames should be", "one of the two");
  if (params.reuse.mode == Reuse::kNone && params.reuse.min_psnr_db)
    throw usage_error("--min-psnr", "means nothing where every frame is traced", "it together with --reuse forward");
  if (const std::string against = flag_against_floor(params); params.reuse.min_psnr_db && !against.empty())
    throw usage_error(against, "cannot be together with --min-psnr, which traces what is missed or doubted", "one of the two");
  if (params.reuse.debug == DebugPicture::kMissed && params.reuse.fill == MissedFill::kRetrace)
    throw usage_error("--fill", "retraced pixels would not be seen: --debug missed leaves them black", "one of the two");
}

void check_floor(const RenderParams& params) {
  if (params.reuse.min_psnr_db && !tone_of(params).is_identity())
    throw usage_error("--min-psnr", "is a floor for pictures that show light as it is", "no --exposure and --tone with it");
}

ForwardParams forward_params(const FrameParams& params) {
  ForwardParams forward;
  forward.splat = {params.reuse.splat, !params.reuse.no_z_buffer};
  forward.fill = params.reuse.debug == DebugPicture::kMissed ? MissedFill::kBlack : params.reuse.fill;
  if (params.reuse.min_psnr_db) forward.floor = FloorParams{*params.reuse.min_psnr_db, params.sampling.seed};
  forward.order = params.sampling.order;
  return forward;
}

}  // namespace lippmann
