// What the parameters say about reuse between frames.
#pragma once

#include "render/params.hpp"

namespace lippmann {

inline constexpr int kDefaultKeyframes = 8;
inline constexpr int kMaxKeyframes = 4096;
inline constexpr double kLeastPsnr = 20.0, kMostPsnr = 90.0;            ///< floors that can be asked for
inline constexpr double kLeastBudgetS = 0.001, kMostBudgetS = 86400.0;  ///< seconds of a frame, likewise

/// Throws a usage Error for parameters of reuse that contradict each other, or that mean nothing in the mode asked for.
void check_reuse(const FrameParams& params);

/// Throws a usage Error for an error that is asked for of pictures of another tone.
void check_floor(const RenderParams& params);

/// Every how many frames one is traced, or at least is, where it is chosen; reuse only.
inline int key_frame_interval(const FrameParams& params) { return params.reuse.keyframes.value_or(kDefaultKeyframes); }

ForwardParams forward_params(const FrameParams& params);

}  // namespace lippmann
