// Selects how the frames of an animation reuse pixels of other frames.
#pragma once

#include <optional>
#include <variant>

#include "lippmann/reuse/projection_choices.hpp"

namespace lippmann {

/// CopySettled if the sampling allows it, otherwise TraceAll.
struct AutoReuse {};

/// Traces every frame completely.
struct TraceAll {};

/// Copies pixels from key frames where they provably do not change. Frames have the same bits as with TraceAll. Requires
/// Whitted shading.
struct CopySettled {
  /// Distance between key frames. Empty: chosen automatically.
  std::optional<int> keyframes{};
};

/// Interpolates frames by the method of Eljdid, Aggoun and Youssef (README.md): projects the points of key frames into the
/// frames between them, and fills pixels without a point. Requires Whitted shading.
struct Interpolate {
  /// Distance between key frames. Empty: chosen automatically if min_psnr_db is set, otherwise kDefaultKeyframes.
  std::optional<int> keyframes{};
  /// Lowest PSNR of every frame, in dB, measured in 8-bit codes. Uncertain pixels are traced to reach it. Empty: no limit.
  std::optional<double> min_psnr_db{};
  SplatMode splat = SplatMode::kView;
  MissedFill fill = MissedFill::kInterpolate;
  /// Also interpolates between interpolated frames, not only between key frames.
  bool halving = false;
  /// Lets points overwrite each other in pixel order. This gives wrong images and is for experiments only.
  bool no_z_buffer = false;
};

using Reuse = std::variant<AutoReuse, TraceAll, CopySettled, Interpolate>;

/// Default distance between key frames for Interpolate.
inline constexpr int kDefaultKeyframes = 8;

/// Returns "auto", "none", "copy" or "interpolate".
const char* name_of(const Reuse& reuse);

}  // namespace lippmann
