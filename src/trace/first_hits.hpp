// Fills the layers of a frame that describe the first surface behind each pixel's centre.
#pragma once

#include "lippmann/core/math.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/scene/timeline.hpp"
#include "lippmann/trace/aovs.hpp"
#include "lippmann/trace/ray_order.hpp"
#include "trace/shot.hpp"

namespace lippmann {

/// The scene in the current and the previous frame. The device scene must be at the time of `now`.
struct FrameStep {
  const ResolvedScene& now;
  const ResolvedScene& before;
  Affine3f world_from_display_before;
};

/// Fills the requested first-hit layers of `aovs`. One ray passes through the centre of each pixel, and ignores surfaces with
/// an alpha below `least_opacity`. If `step` is null, all motion is zero.
void find_first_hits(const Shot& shot, RayOrder order, const FrameStep* step, const ThreadPool& pool, FrameAovs& aovs,
                     float least_opacity = 0.5f);

}  // namespace lippmann
