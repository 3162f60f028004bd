// Converts the parameters of reuse to one kind of reuse and its parameters (frames/reuse.hpp).
#pragma once

#include "job/resolved_job.hpp"

namespace lippmann {

inline constexpr int kMaxKeyframes = 4096;
inline constexpr double kMinPsnr = 20.0, kMaxPsnr = 90.0;  ///< range of --min-psnr in dB

/// kAuto is replaced by the kind of reuse that suits the job's sampling. Throws a usage Error for parameters that the
/// resulting kind does not use, and for everything that check() rejects.
FrameParams frame_params(const ResolvedJob& job);

/// Throws a usage Error if a minimum PSNR is combined with exposure or tone mapping.
void check_floor(const RenderParams& params);

}  // namespace lippmann
