// What the frames of an animation take from each other: one of several kinds of reuse, each with its own parameters.
#pragma once

#include <optional>
#include <variant>

#include "lippmann/reuse/projection_choices.hpp"

namespace lippmann {

/// CopySettled where the sampling allows it, else TraceAll: see resolved_reuse().
struct AutoReuse {};

/// Every frame is traced, and nothing is shared.
struct TraceAll {};

/// Whitted's shading: pixels that provably stay as they are are copied from key frames. The same bits as TraceAll.
struct CopySettled {
  std::optional<int> keyframes{};  ///< a key frame every so many frames; none: chosen where it pays
};

/// The paper's: frames between key frames are made from the points of these, and what no point lands on is filled. Whitted's
/// shading alone.
struct Interpolate {
  std::optional<int> keyframes{};       ///< a key frame every so many frames; none: kDefaultKeyframes, or chosen with a floor
  std::optional<double> min_psnr_db{};  ///< a floor for every frame, 8-bit codes: uncertain pixels are traced; none: no floor
  SplatMode splat = SplatMode::kView;
  MissedFill fill = MissedFill::kInterpolate;
  bool halving = false;      ///< made frames are sources too (reuse/frame_plan.hpp); else key frames only
  bool no_z_buffer = false;  ///< points overwrite each other in pixel order: wrong, for study
};

using Reuse = std::variant<AutoReuse, TraceAll, CopySettled, Interpolate>;

/// The default for interpolated animations.
inline constexpr int kDefaultKeyframes = 8;

/// auto, none, copy or interpolate.
const char* name_of(const Reuse& reuse);

}  // namespace lippmann
