// Fills the layers of a frame that say what the first hit behind every pixel's centre is.
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/scene/timeline.hpp"
#include "lippmann/trace/aovs.hpp"
#include "lippmann/trace/ray_order.hpp"
#include "trace/shot.hpp"

namespace lippmann {

/// Where everything is in a frame, which is that of the device scene, and where it was in the frame before.
struct FrameStep {
  const ResolvedScene& now;
  const ResolvedScene& before;
  Affine3f world_from_display_before;
};

/// Fills the layers of `aovs` that are wanted and of first hits: one ray through the centre of every pixel. Without `step`
/// nothing has moved. Surfaces whose alpha is below least_opacity are holes. The same bits for any number of threads.
void find_first_hits(const Shot& shot, RayOrder order, const FrameStep* step, const ThreadPool& pool, FrameAovs& aovs,
                     float least_opacity = 0.5f);

}  // namespace lippmann
