// Converts the parameters of reuse to a kind of reuse with its own parameters (frames/reuse.hpp).
#pragma once

#include "job/resolved_job.hpp"

namespace lippmann {

inline constexpr int kMaxKeyframes = 4096;
inline constexpr double kMinPsnr = 20.0, kMaxPsnr = 90.0;  ///< range of --min-psnr

/// Returns how the frames of a job are made, with kAuto resolved by its sampling. Throws a usage Error for parameters without
/// effect on the resulting kind of reuse, and for everything that check() rejects.
FrameParams frame_params(const ResolvedJob& job);

/// Throws a usage Error if a minimum PSNR is combined with exposure or tone mapping.
void check_floor(const RenderParams& params);

}  // namespace lippmann
