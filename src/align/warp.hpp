// Resamples a window of an aligned image.
#pragma once

#include "align/similarity.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Transforms the image and returns the window that starts at `corner`, using a Lanczos filter with three lobes. Pixels keep
/// their values if the motion is a whole number of pixels. The edges of the image are extended outwards.
Image warped(const Image& picture, const Similarity& aligned_from_picture, Vec2i corner, Vec2i size, const ThreadPool& pool);

}  // namespace lippmann
