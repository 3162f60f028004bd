// Parameters for rendering the frames of a scene for given optics: the sampling of each frame, and the reuse between frames.
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

/// Removal of the noise of path tracing.
enum class Denoise {
  /// Denoises path-traced frames with 2 or more samples per pixel.
  kAuto,
  kNone,  ///< does not denoise
};

/// How a frame is traced, and which layers it has.
struct Sampling {
  std::optional<Integrator> integrator{};  ///< empty: chosen by completed()
  RayOrder order = RayOrder::kViewTiles;
  /// Samples per pixel. 0: chosen by completed() or the integrator.
  int spp = 0;
  /// Filter over the angles of a view. Empty: kBox if a picture is for a display and has 2 or more samples per pixel, otherwise
  /// none. Only quilts are filtered.
  std::optional<AngularFilter> angular_filter{};
  /// Depth of field. Needs 2 or more samples per pixel.
  ViewLens lens{};
  /// Motion blur: fraction of the frame interval, 0 to 1, for which the shutter is open. The open time is centred on the
  /// frame's time.
  float shutter = 0.0f;
  /// Largest number of path vertices. 0: the limit of the scene.
  int max_depth = 0;
  std::uint32_t seed = 0;
  /// Path tracing: largest indirect light of a path, as linear light. 0: no limit.
  float clamp_indirect = 0.0f;
  Denoise denoise = Denoise::kAuto;
  /// Adds an alpha channel. The background lights the scene but is invisible.
  bool transparent = false;
  std::vector<Aov> aov{};  ///< extra layers of each frame
};

/// All parameters of frames except the scene and its optics.
struct FrameParams {
  Sampling sampling{};
  Reuse reuse{};
};

/// Returns `sampling` with an integrator, which is chosen if `sampling` has none:
/// - Physical scenes: path tracing with 16 samples per pixel, or Whitted shading with 1 if frames are interpolated.
/// - Whitted scenes: Whitted shading with 1 sample per pixel.
/// - Splats: Whitted shading with 4 samples per pixel, unless `sampling` sets spp.
Sampling completed(Sampling sampling, SceneKind scene, bool interpolates);

inline Integrator integrator_of(const Sampling& sampling) { return sampling.integrator.value_or(Integrator::kWhitted); }
inline const IntegratorFacts& facts_of(const Sampling& sampling) { return integrator_of(sampling).facts(); }

inline int samples_per_pixel(const Sampling& sampling) {
  return sampling.spp > 0 ? sampling.spp : facts_of(sampling).default_samples;
}

/// Frames with one sample per pixel are never denoised, because their noise cannot be estimated.
inline bool is_denoised(const Sampling& sampling) {
  return sampling.denoise == Denoise::kAuto && facts_of(sampling).is_stochastic && samples_per_pixel(sampling) > 1;
}

/// Returns whether CopySettled can be used. It requires Whitted shading without motion blur and transparency. Provenance may be
/// the only extra layer.
bool can_copy_settled(const Sampling& sampling);

/// Returns params.reuse. Replaces AutoReuse by CopySettled if the sampling allows it, otherwise by TraceAll.
Reuse resolved_reuse(const FrameParams& params);

/// Throws a usage Error if parameters are out of range, contradict each other, or do not apply to `optics`. The error names the
/// parameter as in job files (min-psnr for min_psnr_db) and the accepted values.
void check(const FrameParams& params, const Optics& optics);

/// Like the function above, but only for the checks that need no optics. Throws a usage Error.
void check(const FrameParams& params);

}  // namespace lippmann
