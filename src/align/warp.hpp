#pragma once

#include "align/similarity.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Transforms the image with a Lanczos filter with three lobes, and returns the window that starts at `corner`. Pixels keep
/// their values if the image moves by a whole number of pixels. Beyond its edges, the image is extended by its edge pixels.
Image warped(const Image& picture, const Similarity& aligned_from_picture, Vec2i corner, Vec2i size, const ThreadPool& pool);

}  // namespace lippmann
