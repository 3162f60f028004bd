#include "render/reuse_params.hpp"

#include <string>

#include "core/error.hpp"
#include "render/lit_frames.hpp"

namespace lippmann {
namespace {

/// The first flag that only reuse forward knows and that is not as it is by default; empty if there is none.
std::string forward_only_flag(const RenderParams& params) {
  const RenderParams defaults;
  if (params.splat != defaults.splat) return "--splat";
  if (params.fill != defaults.fill) return "--fill";
  if (params.halving) return "--halving";
  if (params.no_z_buffer) return "--no-z-buffer";
  if (params.debug == DebugPicture::kMissed) return "--debug";
  return "";
}

/// The first flag that would take from a frame what its floor promises; empty if there is none.
std::string flag_against_floor(const RenderParams& params) {
  const RenderParams defaults;
  if (params.fill != defaults.fill) return "--fill";
  if (params.halving) return "--halving";
  if (params.no_z_buffer) return "--no-z-buffer";
  if (params.debug != defaults.debug) return "--debug";
  return "";
}

}  // namespace

void check_reuse(const RenderParams& params) {
  const std::string stray = forward_only_flag(params);
  if (params.reuse != Reuse::kForward && !stray.empty())
    throw usage_error(stray, "means nothing without interpolated frames", "it together with --reuse forward");
  if (params.debug == DebugPicture::kProvenance && (params.denoise || !LitFrames::serves(params)))
    throw usage_error("--debug", "provenance shows where reused light came from, and none is",
                      "--integrator path --reuse exact with it, 8 --spp or more, no --denoise and no --aov direct or indirect");
  if (params.reuse == Reuse::kNone && params.keyframes)
    throw usage_error("--keyframes", "means nothing where every frame is traced", "it together with --reuse exact or forward");
  if (params.reuse == Reuse::kForward && integrator_of(params) == Integrator::kPath)
    throw usage_error("--reuse", "forward does not know path-traced frames", "none or exact, or --integrator whitted");
  if (params.time_budget_s && !LitFrames::serves(params))
    throw usage_error("--time-budget", "is for path-traced frames that share light",
                      "--integrator path --reuse exact with it, and no --aov direct or indirect");
  if (params.time_budget_s && params.min_psnr_db)
    throw usage_error("--time-budget", "and --min-psnr both say how good frames should be", "one of the two");
  if (params.reuse == Reuse::kNone && params.min_psnr_db)
    throw usage_error("--min-psnr", "means nothing where every frame is traced", "it together with --reuse forward");
  if (const std::string against = flag_against_floor(params); params.min_psnr_db && !against.empty())
    throw usage_error(against, "cannot be together with --min-psnr, which traces what is missed or doubted", "one of the two");
  if (params.min_psnr_db && !tone_of(params).is_identity())
    throw usage_error("--min-psnr", "is a floor for pictures that show light as it is", "no --exposure and --tone with it");
  if (params.debug == DebugPicture::kMissed && params.fill == MissedFill::kRetrace)
    throw usage_error("--fill", "retraced pixels would not be seen: --debug missed leaves them black", "one of the two");
}

ForwardParams forward_params(const RenderParams& params) {
  ForwardParams forward;
  forward.splat = {params.splat, !params.no_z_buffer};
  forward.fill = params.debug == DebugPicture::kMissed ? MissedFill::kBlack : params.fill;
  if (params.min_psnr_db) forward.floor = FloorParams{*params.min_psnr_db, params.seed};
  forward.order = params.order;
  return forward;
}

}  // namespace lippmann
