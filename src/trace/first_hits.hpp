// Fills the layers of a frame that describe the first hit behind each pixel's centre.
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/scene/timeline.hpp"
#include "lippmann/trace/aovs.hpp"
#include "lippmann/trace/ray_order.hpp"
#include "trace/shot.hpp"

namespace lippmann {

/// The scene in the current frame, which the device scene shows, and in the previous frame.
struct FrameStep {
  const ResolvedScene& now;
  const ResolvedScene& before;
  Affine3f world_from_display_before;
};

/// Fills the wanted first-hit layers of `aovs` with one ray through the centre of each pixel. Without `step`, all motion is
/// zero. Rays pass through surfaces with an alpha below `least_opacity`. The result does not depend on the number of threads.
void find_first_hits(const Shot& shot, RayOrder order, const FrameStep* step, const ThreadPool& pool, FrameAovs& aovs,
                     float least_opacity = 0.5f);

}  // namespace lippmann
