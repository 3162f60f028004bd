// How the frames of an RGB-D render code depth: alike in all of them, so that grey means the same depth throughout a video.
#pragma once

#include "folder/picture_params.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {

struct Stage;

/// The range that is asked for, else what the scene shows of itself over its whole animation, whichever frames, strips or parts
/// of it are rendered. Throws a usage Error for a range that is not before the eye.
FormatOptions rgbd_options(const DepthParams& wanted, const Stage& stage, const ThreadPool& pool);

}  // namespace lippmann
