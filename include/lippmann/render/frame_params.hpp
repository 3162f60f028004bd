// How the frames of a scene on its optics are made: how each is traced, and what it takes from others. It knows no scene's
// name, no folder and no flag; render/params.hpp adds those.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lippmann/optics/angular_filter.hpp"
#include "lippmann/reuse/projection_choices.hpp"
#include "lippmann/trace/aovs.hpp"
#include "lippmann/trace/integrator.hpp"
#include "lippmann/trace/ray_order.hpp"

namespace lippmann {

enum class Reuse {
  kNone,     ///< every frame is traced
  kExact,    ///< Whitted: pixels that provably stay as they are are copied from key frames, the same bits as kNone; paths:
             ///< soft light is shared by pixels, views and frames
  kForward,  ///< the paper's: frames between key frames are interpolated from these frames' points
};
enum class DebugPicture { kNone, kMissed, kProvenance };

/// How a frame is traced, and which layers it has.
struct Sampling {
  std::optional<Integrator> integrator{};  ///< none: see with_scene_defaults
  RayOrder order = RayOrder::kViewTiles;
  int spp = 0;                                    ///< samples per pixel; 0: 1, of paths kPathSamples
  std::optional<AngularFilter> angular_filter{};  ///< none: see wanted_angular_filter (render/frame.hpp)
  int max_depth = 0;                              ///< path vertices; 0: the scene's own limit
  std::uint32_t seed = 0;
  float clamp_indirect = 0.0f;  ///< paths: the brightest indirect contribution to a sample; 0: any
  bool denoise = false;         ///< paths: frames are filtered (denoise/denoiser.hpp)
  bool transparent = false;     ///< pictures have alpha: the surroundings light the scene but are not seen
  std::vector<Aov> aov{};       ///< extra layers beside the picture
};

/// What frames take from each other.
struct ReuseParams {
  Reuse mode = Reuse::kExact;
  std::optional<int> keyframes{};         ///< a key frame every K frames; none: exact chooses, forward takes kDefaultKeyframes
  std::optional<double> min_psnr_db{};    ///< of every frame, 8-bit codes; none: forward's errors are not bounded
  std::optional<double> time_budget_s{};  ///< of a path-traced frame, about, on this machine; none: as long as it takes
  SplatMode splat = SplatMode::kView;
  MissedFill fill = MissedFill::kInterpolate;  ///< kInterpolate or kRetrace
  bool halving = false;                        ///< made frames are sources too (reuse/frame_plan.hpp); else key frames only
  bool no_z_buffer = false;                    ///< points overwrite each other in pixel order: wrong, for study
  DebugPicture debug = DebugPicture::kNone;    ///< kMissed: missed pixels stay black; kProvenance: where light came from
};

/// All that frames of a scene and its optics depend on. Values that are out of range are refused where text is read
/// (render/params_table.cpp), combinations that contradict each other by check_reuse() and its like.
struct FrameParams {
  Sampling sampling{};
  ReuseParams reuse{};
};

/// Samples per pixel where nothing is said: of paths that are asked for, and of those that are the scene's default, so that a
/// first picture comes within seconds.
inline constexpr int kPathSamples = 64, kFirstPathSamples = 16;

inline Integrator integrator_of(const FrameParams& params) { return params.sampling.integrator.value_or(Integrator::kWhitted); }

inline int samples_per_pixel(const FrameParams& params) {
  return params.sampling.spp > 0 ? params.sampling.spp : integrator_of(params) == Integrator::kPath ? kPathSamples : 1;
}

}  // namespace lippmann
