// A window of an aligned picture.
#pragma once

#include "align/similarity.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Moves the picture by `aligned_from_picture` and returns the window from `corner` on, by Lanczos's filter of three lobes.
/// Pixels that are not moved, or by whole pixels, keep their values. Beyond its edges the picture continues with its edges.
Image warped(const Image& picture, const Similarity& aligned_from_picture, Vec2i corner, Vec2i size, const ThreadPool& pool);

}  // namespace lippmann
