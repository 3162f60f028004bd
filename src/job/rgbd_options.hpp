// Chooses the depth coding of an RGB-D render. All frames share it, so that a grey level means the same depth
// throughout a video.
#pragma once

#include "folder/picture_params.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {

struct Stage;

/// Uses the requested depth range, or the range that is visible in the whole animation. Throws a usage Error for a
/// range that is not in front of the eye.
FormatOptions rgbd_options(const DepthParams& wanted, const Stage& stage, const ThreadPool& pool);

}  // namespace lippmann
