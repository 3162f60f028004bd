// From the parameters of reuse to the kind of reuse with its own parameters (frames/reuse.hpp).
#pragma once

#include "job/resolved_job.hpp"

namespace lippmann {

inline constexpr int kMaxKeyframes = 4096;
inline constexpr double kLeastPsnr = 20.0, kMostPsnr = 90.0;  ///< floors that can be asked for

/// How the frames of a job are made: kAuto becomes what its sampling allows.
/// Throws a usage Error for parameters of reuse that mean nothing to the kind that serves, and for all that check() refuses.
FrameParams frame_params(const ResolvedJob& job);

/// Throws a usage Error for a floor that is asked of pictures of another tone.
void check_floor(const RenderParams& params);

}  // namespace lippmann
