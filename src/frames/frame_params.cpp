#include "lippmann/frames/frame_params.hpp"

#include <algorithm>
#include <string>

#include "lippmann/core/error.hpp"
#include "lippmann/optics/crosstalk.hpp"

namespace lippmann {
namespace {

/// Fewer paths a pixel leave nothing to be saved.
constexpr int kLeastPaths = 8;

bool has_layer(const Sampling& sampling, Aov layer) {
  return std::find(sampling.aov.begin(), sampling.aov.end(), layer) != sampling.aov.end();
}

/// But for provenance, which whatever makes a frame tells, layers are of every pixel.
bool has_layers_of_every_pixel(const Sampling& sampling) {
  return std::any_of(sampling.aov.begin(), sampling.aov.end(), [](Aov layer) { return layer != Aov::kProvenance; });
}

/// What only paths have as parts.
bool has_layers_of_paths(const Sampling& sampling) {
  return has_layer(sampling, Aov::kDirect) || has_layer(sampling, Aov::kIndirect);
}

void check_reuse(const AutoReuse&, const Sampling&) {}
void check_reuse(const TraceAll&, const Sampling&) {}

void check_reuse(const CopySettled&, const Sampling& sampling) {
  if (integrator_of(sampling) == Integrator::kPath)
    throw usage_error("reuse", "copy knows pixels of Whitted's shading; path-traced ones have other noise in every frame",
                      "light, none or auto, or `integrator` whitted");
  if (!can_copy_settled(sampling))
    throw usage_error("reuse",
                      "alpha and extra layers but provenance are of every pixel of every frame: nothing is left to copy",
                      "none or auto");
}

void check_reuse(const ShareLight& light, const Sampling& sampling) {
  if (light.time_budget_s && light.min_psnr_db)
    throw usage_error("time-budget", "and `min-psnr` both say how good frames should be", "one of the two");
  if (light.time_budget_s && light.quality_at == QualityAt::kEye)
    throw usage_error("quality-at", "eye means nothing with `time-budget`, which takes what time allows", "one of the two");
  if (!(light.crosstalk_px >= 0.0 && light.crosstalk_px <= kMaxBlurPx))
    throw usage_error("crosstalk", "is no sigma of neighbours that are seen", "0 to 8 pixels or views");
  if (can_share_light(sampling, light)) return;
  if (integrator_of(sampling) != Integrator::kPath)
    throw usage_error("reuse", "only paths share light", "`integrator` path with it, or copy, interpolate, none or auto");
  if (has_layers_of_paths(sampling))
    throw usage_error("aov", "direct and indirect are parts of whole paths, of which no light is shared",
                      "`reuse` none or auto with them");
  throw usage_error("spp", "of so few paths there is nothing to be saved", "8 or more, or `reuse` none or auto");
}

/// The member that would take from a frame what its floor promises; empty if there is none.
std::string against_floor(const Interpolate& how) {
  if (how.fill != MissedFill::kInterpolate) return "fill";
  if (how.halving) return "halving";
  return how.no_z_buffer ? "no-z-buffer" : "";
}

void check_reuse(const Interpolate& how, const Sampling& sampling) {
  if (integrator_of(sampling) == Integrator::kPath)
    throw usage_error("reuse", "interpolate does not know path-traced frames", "none, light or auto, or `integrator` whitted");
  if (sampling.transparent) throw usage_error("transparent", "interpolated frames have no alpha", "`reuse` none with it");
  if (has_layers_of_every_pixel(sampling))
    throw usage_error("aov", "interpolated frames have no extra layers but provenance", "`reuse` none with it");
  if (sampling.angular_filter == AngularFilter::kBox)
    throw usage_error("angular-filter", "points that are moved to be interpolated are those of one eye",
                      "`reuse` copy, light, none or auto");
  if (const std::string against = against_floor(how); how.min_psnr_db && !against.empty())
    throw usage_error(against, "cannot be together with `min-psnr`, which traces what is missed or uncertain",
                      "one of the two");
}

void check_sampling(const Sampling& sampling) {
  const bool paths = integrator_of(sampling) == Integrator::kPath;
  if (has_layers_of_paths(sampling) && !paths)
    throw usage_error("aov", "direct and indirect are parts of the light that paths find", "`integrator` path with them");
  if (!sampling.denoise) return;
  if (!paths) throw usage_error("denoise", "only paths have noise", "`integrator` path with it");
  if (samples_per_pixel(sampling) < 2)
    throw usage_error("denoise", "the noise of one sample cannot be told", "`spp` of 2 or more with it");
}

}  // namespace

const char* name_of(const Reuse& reuse) {
  constexpr const char* kNames[] = {"auto", "none", "copy", "light", "interpolate"};
  return kNames[reuse.index()];
}

bool can_share_light(const Sampling& sampling, const ShareLight& light) {
  return integrator_of(sampling) == Integrator::kPath && !has_layers_of_paths(sampling) &&
         (samples_per_pixel(sampling) >= kLeastPaths || light.min_psnr_db || light.time_budget_s);
}

bool can_copy_settled(const Sampling& sampling) {
  return integrator_of(sampling) == Integrator::kWhitted && !has_layers_of_every_pixel(sampling) && !sampling.transparent &&
         !sampling.denoise;
}

Reuse resolved_reuse(const FrameParams& params) {
  if (!std::holds_alternative<AutoReuse>(params.reuse)) return params.reuse;
  if (can_share_light(params.sampling)) return ShareLight{};
  if (can_copy_settled(params.sampling)) return CopySettled{};
  return TraceAll{};
}

void check(const FrameParams& params) {
  check_sampling(params.sampling);
  std::visit([&](const auto& reuse) { check_reuse(reuse, params.sampling); }, params.reuse);
}

void check(const FrameParams& params, const Optics& optics) {
  check(params);
  if (params.sampling.angular_filter != AngularFilter::kBox) return;
  constexpr const char* kField = "angular-filter";
  if (!view_tiles(optics))
    throw usage_error(kField,
                      "only views have eyes to be spread: below lenses, the samples of a pixel are seen from all of its "
                      "directions anyway",
                      "`optics` multiview, or `spp` alone");
  if (samples_per_pixel(params.sampling) == 1)
    throw usage_error(kField, "one sample is seen from one eye", "`spp` of 2 or more with it");
}

}  // namespace lippmann
