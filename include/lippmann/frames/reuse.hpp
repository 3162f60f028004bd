// Selects how the frames of an animation reuse pixels of other frames. Each kind of reuse has its own parameters.
#pragma once

#include <optional>
#include <variant>

#include "lippmann/reuse/projection_choices.hpp"

namespace lippmann {

/// Selects CopySettled if the sampling allows it, otherwise TraceAll (see resolved_reuse()).
struct AutoReuse {};

/// Traces every frame completely.
struct TraceAll {};

/// Copies pixels from key frames where they provably do not change. Frames have the same bits as with TraceAll. Requires
/// Whitted shading.
struct CopySettled {
  /// Number of frames from one key frame to the next. If empty, it is chosen automatically.
  std::optional<int> keyframes{};
};

/// Interpolates frames by the method of Eljdid, Aggoun and Youssef (README.md). Projects the points of key frames into the
/// frames between them, and then fills the pixels that no point projects onto. Requires Whitted shading.
struct Interpolate {
  /// Number of frames from one key frame to the next. If empty, it is kDefaultKeyframes, or chosen automatically with
  /// min_psnr_db.
  std::optional<int> keyframes{};
  /// Minimum PSNR of every frame, in dB, measured in 8-bit codes. Uncertain pixels are traced so that frames reach this
  /// minimum. If empty, there is no minimum.
  std::optional<double> min_psnr_db{};
  SplatMode splat = SplatMode::kView;
  MissedFill fill = MissedFill::kInterpolate;
  /// Uses interpolated frames as sources, and not only key frames (reuse/frame_plan.hpp).
  bool halving = false;
  /// Lets points overwrite each other in pixel order. This gives wrong images and is for experiments only.
  bool no_z_buffer = false;
};

using Reuse = std::variant<AutoReuse, TraceAll, CopySettled, Interpolate>;

/// Default number of frames from one key frame to the next for Interpolate.
inline constexpr int kDefaultKeyframes = 8;

/// Returns "auto", "none", "copy" or "interpolate".
const char* name_of(const Reuse& reuse);

}  // namespace lippmann
