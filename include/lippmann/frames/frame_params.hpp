// How the frames of a scene on its optics are made: how each is sampled, and what it takes from others. It knows no scene's
// name, no folder and no flag.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lippmann/frames/reuse.hpp"
#include "lippmann/optics/angular_filter.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/view_lens.hpp"
#include "lippmann/trace/aovs.hpp"
#include "lippmann/trace/integrator.hpp"
#include "lippmann/trace/ray_order.hpp"

namespace lippmann {

/// Whether the noise of path tracing is removed (denoise/denoiser.hpp).
enum class Denoise {
  kAuto,  ///< of path-traced frames with 2 or more samples per pixel: see is_denoised()
  kNone,  ///< frames stay as traced
};

/// How a frame is traced, and which layers it has.
struct Sampling {
  std::optional<Integrator> integrator{};  ///< none: Whitted's
  RayOrder order = RayOrder::kViewTiles;
  int spp = 0;                                    ///< samples per pixel; 0: 1, of paths kPathSamples
  std::optional<AngularFilter> angular_filter{};  ///< none: kBox for several samples of a display's quilt, see PlacedOptics
  ViewLens lens{};                                ///< of views: depth of field; 2 or more samples per pixel
  float shutter = 0.0f;  ///< motion blur: open for this share of the time from frame to frame, around the frame's; 0 to 1
  int max_depth = 0;     ///< path vertices; 0: the scene's own limit
  std::uint32_t seed = 0;
  float clamp_indirect = 0.0f;  ///< paths: the brightest indirect contribution to a sample; 0: any
  Denoise denoise = Denoise::kAuto;
  bool transparent = false;  ///< pictures have alpha: the surroundings light the scene but are not seen
  std::vector<Aov> aov{};    ///< extra layers beside the picture
};

/// All that frames of a scene and its optics depend on.
struct FrameParams {
  Sampling sampling{};
  Reuse reuse{};
};

/// Samples per pixel of paths by default.
inline constexpr int kPathSamples = 16;

inline Integrator integrator_of(const Sampling& sampling) { return sampling.integrator.value_or(Integrator::kWhitted); }

inline int samples_per_pixel(const Sampling& sampling) {
  return sampling.spp > 0 ? sampling.spp : integrator_of(sampling) == Integrator::kPath ? kPathSamples : 1;
}

/// Whether frames are denoised: not where the noise cannot be estimated, from one sample per pixel.
inline bool is_denoised(const Sampling& sampling) {
  return sampling.denoise == Denoise::kAuto && integrator_of(sampling) == Integrator::kPath && samples_per_pixel(sampling) > 1;
}

/// Whether frames sampled so can be copied where they stay as they are: Whitted's shading, no layers beside the picture but
/// provenance, and no motion blur.
bool can_copy_settled(const Sampling& sampling);

/// The kind of reuse that serves: as it is, and of AutoReuse what the sampling allows.
Reuse resolved_reuse(const FrameParams& params);

/// Throws a usage Error for parameters that are out of range, contradict each other, or that the optics do not have. It names
/// the member (min-psnr for min_psnr_db, as job files do) and what would be accepted.
void check(const FrameParams& params, const Optics& optics);

/// The part of it that does not depend on the optics.
void check(const FrameParams& params);

}  // namespace lippmann
