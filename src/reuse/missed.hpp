// Finds out why no point landed on a pixel of an in-between frame, and chooses the pixel's colour.
//
// The paper names two causes. The cause follows from the surface that the pixel shows. This surface is taken from the nearest
// pixels with a point to the left and right in the same view (or below the same lens). The one farther from the viewer is used,
// because newly visible parts come from behind. The point of that surface behind the pixel is moved to both source frames:
//   newly visible  the point lies within the image (of its view, or its lens) of at least one source: something nearer occluded
//                  it there. This also includes gaps of whole pixels in a stretched surface.
//   not covered    the point lies outside both images. This also includes pixels without neighbours.
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

/// The two sources of an in-between frame after splatting.
struct SplatPair {
  const SplatSource &previous, &following;
  const Motion &back_to_previous, &back_to_following;  ///< from the in-between frame's moment
};

/// Counts the causes for the pixels in `missed` (ascending). Unless `film` is null, sets each pixel to the mean of its nearest
/// neighbours with a point: one to the left and one to the right in its view (or lens), and one up and one down within
/// kFillReach steps, weighted by the inverse of their distance in pixels. Neighbours in front of the farthest one are ignored,
/// because newly visible parts were behind. Without neighbours, uses the mean of the two sources' colours of the same pixel.
MissedCauses resolve_missed(const SplatPair& pair, const Splatter& splatter, const ViewSteps& steps,
                            std::span<const std::uint32_t> missed, const ThreadPool& pool, Image* film);

inline constexpr int kFillReach = 16;

}  // namespace lippmann
