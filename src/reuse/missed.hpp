// Pixels of an in-between frame onto which no point has landed: why, and what they show instead.
//
// The paper names two causes. Which one it was is found by asking what the pixel shows: the surface around it, that is, of its
// nearest neighbours to the left and right in the same view (or below the same lens) which have a point, the one farther from
// the viewer, because what comes into view comes from behind. That surface's point behind the pixel is carried back to both
// source frames:
//   newly visible  it lies within the picture (of its view, or its lens) of at least one of them: the area was covered, and
//                  something nearer hid it there. Gaps that whole pixels leave where a surface stretches count here too.
//   not covered    it lies outside both: neither frame's pictures reached so far. Also a pixel without neighbours.
#pragma once

#include <cstdint>
#include <span>

#include "lippmann/image/image.hpp"
#include "optics/view_steps.hpp"
#include "reuse/average.hpp"
#include "reuse/splat.hpp"

namespace lippmann {

struct MissedCauses {
  std::uint64_t newly_visible = 0, not_covered = 0;
};

/// What the two sources leave to know about an in-between frame after splatting.
struct SplatPair {
  const SplatSource &previous, &following;
  const Motion &back_to_previous, &back_to_following;  ///< from the in-between frame's moment
};

/// Counts the causes of the pixels in `missed` (ascending) and, unless `film` is null, gives each the mean of its nearest
/// neighbours that have a point: one to the left and one to the right of its view (or lens), and one up and one down within
/// kFillReach steps, weighted by the inverse of their distance in pixels. Neighbours that belong to something in front of the
/// farthest of them are left out: what has come into view was behind. Without any: the mean of the two sources' colours of the
/// same pixel.
MissedCauses resolve_missed(const SplatPair& pair, const Splatter& splatter, const ViewSteps& steps,
                            std::span<const std::uint32_t> missed, const ThreadPool& pool, Image* film);

inline constexpr int kFillReach = 16;

}  // namespace lippmann
