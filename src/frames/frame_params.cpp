#include "lippmann/frames/frame_params.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

/// larger apertures would overflow when squared
constexpr float kMostApertureMm = 1e6f;

bool has_layer(const Sampling& sampling, Aov layer) {
  return std::find(sampling.aov.begin(), sampling.aov.end(), layer) != sampling.aov.end();
}

/// Layers other than provenance require that every pixel is traced.
bool has_layers_of_every_pixel(const Sampling& sampling) {
  return std::any_of(sampling.aov.begin(), sampling.aov.end(), [](Aov layer) { return layer != Aov::kProvenance; });
}

bool has_layers_of_paths(const Sampling& sampling) {
  return has_layer(sampling, Aov::kDirect) || has_layer(sampling, Aov::kIndirect);
}

const char* name_of_opening(const ViewLens& lens) { return lens.aperture_mm > 0.0f ? "aperture" : "f-number"; }

void check_key_frames(const std::optional<int>& every) {
  if (every && *every < 1)
    throw usage_error("keyframes", fmt::format("is {}", *every), "1 or more frames from one key frame to the next");
}

void check_floor(const std::optional<double>& min_psnr_db) {
  if (min_psnr_db && !(*min_psnr_db > 0.0 && std::isfinite(*min_psnr_db)))
    throw usage_error("min-psnr", fmt::format("is {} dB", *min_psnr_db), "a number above 0");
}

void check_reuse(const AutoReuse&, const Sampling&) {}
void check_reuse(const TraceAll&, const Sampling&) {}

/// Reused pixels and points belong to a single time, so motion blur is refused.
void refuse_shutter(const Sampling& sampling) {
  if (sampling.shutter > 0.0f)
    throw usage_error("shutter", "motion blur cannot be combined with frames that reuse others", "`reuse` none or auto");
}

void check_reuse(const CopySettled& copy, const Sampling& sampling) {
  check_key_frames(copy.keyframes);
  refuse_shutter(sampling);
  if (!facts_of(sampling).can_share_pixels)
    throw usage_error("reuse", "copy needs Whitted shading; path-traced pixels have different noise in every frame",
                      "none or auto, or `integrator` whitted");
  if (!can_copy_settled(sampling))
    throw usage_error("reuse", "copy cannot make alpha or extra layers, except provenance", "none or auto");
}

std::string against_floor(const Interpolate& how) {
  if (how.fill != MissedFill::kInterpolate) return "fill";
  if (how.halving) return "halving";
  return how.no_z_buffer ? "no-z-buffer" : "";
}

void check_reuse(const Interpolate& how, const Sampling& sampling) {
  check_key_frames(how.keyframes);
  check_floor(how.min_psnr_db);
  if (!facts_of(sampling).can_share_pixels)
    throw usage_error("reuse", "interpolate needs Whitted shading", "none or auto, or `integrator` whitted");
  refuse_shutter(sampling);
  if (sampling.lens.is_open())
    throw usage_error(name_of_opening(sampling.lens), "depth of field cannot be combined with interpolated frames",
                      "`reuse` copy, none or auto");
  if (sampling.transparent) throw usage_error("transparent", "interpolated frames have no alpha", "`reuse` none");
  if (has_layers_of_every_pixel(sampling))
    throw usage_error("aov", "interpolated frames have no extra layers but provenance", "`reuse` none");
  if (sampling.angular_filter == AngularFilter::kBox)
    throw usage_error("angular-filter",
                      "box cannot be combined with interpolated frames, whose points are each seen by one eye",
                      "`reuse` copy, none or auto");
  if (const std::string against = against_floor(how); how.min_psnr_db && !against.empty())
    throw usage_error(against, "cannot be combined with `min-psnr`, which traces missing and uncertain pixels",
                      "one of the two");
}

void check_lens(const ViewLens& lens) {
  if (!(lens.aperture_mm >= 0.0f && lens.aperture_mm <= kMostApertureMm))
    throw usage_error("aperture", fmt::format("is {} mm", lens.aperture_mm), fmt::format("0 to {} mm", kMostApertureMm));
  if (!(lens.f_number >= 0.0f && std::isfinite(lens.f_number)))
    throw usage_error("f-number", fmt::format("is {}", lens.f_number), "a number above 0, or 0 for a pinhole");
  if (lens.aperture_mm > 0.0f && lens.f_number > 0.0f)
    throw usage_error("f-number", "cannot be combined with `aperture`: both set the width of the lens", "one of the two");
  if (!std::isfinite(lens.focal_plane_mm))
    throw usage_error("focal-plane", fmt::format("is {} mm", lens.focal_plane_mm), "a finite number of millimetres");
  if (lens.focal_plane_mm != 0.0f && !lens.is_open())
    throw usage_error("focal-plane", "has no effect without depth of field", "`aperture` or `f-number`");
}

void check_several_samples(const char* field, const char* problem, const Sampling& sampling) {
  if (samples_per_pixel(sampling) < 2) throw usage_error(field, problem, "`spp` of 2 or more");
}

void check_shutter(const Sampling& sampling) {
  if (!(sampling.shutter >= 0.0f && sampling.shutter <= 1.0f))
    throw usage_error("shutter", fmt::format("is {}", sampling.shutter), "a share of the time from frame to frame, 0 to 1");
  if (sampling.shutter > 0.0f) check_several_samples("shutter", "motion blur needs several samples per pixel", sampling);
}

void check_sampling(const Sampling& sampling) {
  if (sampling.spp < 0) throw usage_error("spp", fmt::format("is {}", sampling.spp), "1 or more samples, or 0 for the default");
  if (sampling.max_depth < 0)
    throw usage_error("max-depth", fmt::format("is {}", sampling.max_depth), "1 or more, or 0 for the scene's own limit");
  if (!(sampling.clamp_indirect >= 0.0f))
    throw usage_error("clamp-indirect", fmt::format("is {}", sampling.clamp_indirect), "a number above 0, or 0 for no limit");
  check_lens(sampling.lens);
  check_shutter(sampling);
  if (has_layers_of_paths(sampling) && !facts_of(sampling).separates_light)
    throw usage_error("aov", "the layers direct and indirect need path tracing", "`integrator` path");
}

void check_lens(const Sampling& sampling, const Optics& optics) {
  const char* const field = name_of_opening(sampling.lens);
  if (!can_have_view_lens(optics))
    throw usage_error(field, "depth of field needs optics with views: a lens array already blurs points far from the display",
                      "`optics` single or multiview");
  check_several_samples(field, "depth of field needs several samples per pixel", sampling);
  if (!(sampling.lens.focal_plane_mm < viewing_distance_mm(optics)))
    throw usage_error("focal-plane", fmt::format("at {} mm lies behind the viewer", sampling.lens.focal_plane_mm),
                      fmt::format("less than the viewing distance, {} mm", viewing_distance_mm(optics)));
}

void check_angular_filter(const Sampling& sampling, const Optics& optics) {
  constexpr const char* kField = "angular-filter";
  if (!view_tiles(optics))
    throw usage_error(kField,
                      "box needs optics with views: the samples of a pixel below a lens already cover all of its "
                      "directions",
                      "`optics` multiview, or no `angular-filter`");
  check_several_samples(kField, "box needs several samples per pixel", sampling);
}

}  // namespace

const char* name_of(const Reuse& reuse) {
  constexpr const char* kNames[] = {"auto", "none", "copy", "interpolate"};
  return kNames[reuse.index()];
}

Sampling completed(Sampling sampling, SceneKind scene, bool interpolates) {
  // Splats can be smaller than a pixel, so they need several samples.
  constexpr int kSplatSamples = 4;
  if (sampling.integrator) return sampling;
  if (scene == SceneKind::kSplats && sampling.spp == 0) sampling.spp = kSplatSamples;
  const bool paths = scene == SceneKind::kPhysical && !interpolates;
  sampling.integrator = paths ? Integrator::kPath : Integrator::kWhitted;
  return sampling;
}

bool can_copy_settled(const Sampling& sampling) {
  return facts_of(sampling).can_share_pixels && !has_layers_of_every_pixel(sampling) && !sampling.transparent &&
         sampling.shutter <= 0.0f;
}

Reuse resolved_reuse(const FrameParams& params) {
  if (!std::holds_alternative<AutoReuse>(params.reuse)) return params.reuse;
  if (can_copy_settled(params.sampling)) return CopySettled{};
  return TraceAll{};
}

void check(const FrameParams& params) {
  check_sampling(params.sampling);
  std::visit([&](const auto& reuse) { check_reuse(reuse, params.sampling); }, params.reuse);
}

void check(const FrameParams& params, const Optics& optics) {
  check(params);
  if (params.sampling.lens.is_open()) check_lens(params.sampling, optics);
  if (params.sampling.angular_filter == AngularFilter::kBox) check_angular_filter(params.sampling, optics);
}

}  // namespace lippmann
