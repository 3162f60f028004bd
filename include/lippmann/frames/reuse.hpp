// Reuse of pixels between the frames of an animation: several kinds, each with its own parameters.
#pragma once

#include <optional>
#include <variant>

#include "lippmann/reuse/projection_choices.hpp"

namespace lippmann {

/// Selects CopySettled if the sampling allows it, else TraceAll: see resolved_reuse().
struct AutoReuse {};

/// Traces every frame in full.
struct TraceAll {};

/// Copies pixels from key frames where they provably do not change. Frames have the same bits as with TraceAll. Requires
/// Whitted shading.
struct CopySettled {
  std::optional<int> keyframes{};  ///< frames from one key frame to the next; default: chosen automatically
};

/// Interpolates as in the paper: projects the points of key frames into the frames between them, and fills the pixels that no
/// point projects onto. Requires Whitted shading.
struct Interpolate {
  /// Frames from one key frame to the next; default: kDefaultKeyframes, or chosen automatically with min_psnr_db.
  std::optional<int> keyframes{};
  /// Minimum PSNR of every frame in 8-bit codes, in dB. Uncertain pixels are traced to reach it. Default: no minimum.
  std::optional<double> min_psnr_db{};
  SplatMode splat = SplatMode::kView;
  MissedFill fill = MissedFill::kInterpolate;
  bool halving = false;      ///< use interpolated frames as sources, too (reuse/frame_plan.hpp), not only key frames
  bool no_z_buffer = false;  ///< let points overwrite each other in pixel order; incorrect, for experiments only
};

using Reuse = std::variant<AutoReuse, TraceAll, CopySettled, Interpolate>;

/// Default number of frames from one key frame to the next for Interpolate.
inline constexpr int kDefaultKeyframes = 8;

/// Returns "auto", "none", "copy" or "interpolate".
const char* name_of(const Reuse& reuse);

}  // namespace lippmann
