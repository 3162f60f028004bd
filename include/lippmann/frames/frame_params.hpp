// Parameters for rendering the frames of a scene for its optics: the sampling of each frame, and reuse between frames. Scene
// names, folders and flags are not part of them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lippmann/frames/reuse.hpp"
#include "lippmann/optics/angular_filter.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/view_lens.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/trace/aovs.hpp"
#include "lippmann/trace/integrator.hpp"
#include "lippmann/trace/ray_order.hpp"

namespace lippmann {

/// Selects whether path-tracing noise is removed (denoise/denoiser.hpp).
enum class Denoise {
  kAuto,  ///< denoise path-traced frames with 2 or more samples per pixel: see is_denoised()
  kNone,  ///< do not denoise
};

/// How to trace a frame, and which layers to produce.
struct Sampling {
  std::optional<Integrator> integrator{};  ///< default: see completed()
  RayOrder order = RayOrder::kViewTiles;
  int spp = 0;  ///< samples per pixel; 0: the integrator's default, or see completed()
  /// Default: kBox for a display's quilt with several samples per pixel, see PlacedOptics.
  std::optional<AngularFilter> angular_filter{};
  ViewLens lens{};  ///< depth of field of the views; needs 2 or more samples per pixel
  /// Motion blur: the shutter is open for this share of the frame interval, centred on the frame's time; 0 to 1.
  float shutter = 0.0f;
  int max_depth = 0;  ///< maximum number of path vertices; 0: the scene's own limit
  std::uint32_t seed = 0;
  float clamp_indirect = 0.0f;  ///< path tracing: upper limit of a path's indirect contribution (linear light); 0: none
  Denoise denoise = Denoise::kAuto;
  bool transparent = false;  ///< adds alpha to pictures: the surroundings light the scene but are invisible
  std::vector<Aov> aov{};    ///< extra layers to produce
};

/// All parameters of frames besides the scene and its optics.
struct FrameParams {
  Sampling sampling{};
  Reuse reuse{};
};

/// Chooses the integrator if `sampling` has none. The tool, Renderer and the Python module all use this function.
/// - physical scenes: path tracing with 16 samples per pixel; Whitted shading with 1 if frames are interpolated
/// - Whitted scenes: Whitted shading with 1 sample per pixel
/// - splats: Whitted shading with 4 samples per pixel, unless `sampling` sets spp
Sampling completed(Sampling sampling, SceneKind scene, bool interpolates);

inline Integrator integrator_of(const Sampling& sampling) { return sampling.integrator.value_or(Integrator::kWhitted); }
inline const IntegratorFacts& facts_of(const Sampling& sampling) { return integrator_of(sampling).facts(); }

inline int samples_per_pixel(const Sampling& sampling) {
  return sampling.spp > 0 ? sampling.spp : facts_of(sampling).default_samples;
}

/// Returns whether frames are denoised. One sample per pixel is never denoised, because its noise cannot be estimated.
inline bool is_denoised(const Sampling& sampling) {
  return sampling.denoise == Denoise::kAuto && facts_of(sampling).is_stochastic && samples_per_pixel(sampling) > 1;
}

/// Returns whether CopySettled can be used: only with Whitted shading, without motion blur and transparency, and with no extra
/// layers except provenance.
bool can_copy_settled(const Sampling& sampling);

/// Returns params.reuse. AutoReuse is replaced by CopySettled if the sampling allows it, otherwise by TraceAll.
Reuse resolved_reuse(const FrameParams& params);

/// Throws a usage Error if parameters are out of range, contradict each other, or do not apply to `optics`. The error names the
/// parameter as in job files (min-psnr for min_psnr_db) and the accepted values.
void check(const FrameParams& params, const Optics& optics);

/// Does only the checks that need no optics. Throws a usage Error as the function above.
void check(const FrameParams& params);

}  // namespace lippmann
