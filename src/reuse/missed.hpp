// Finds out why no point landed on a pixel of an in-between frame, and chooses the pixel's colour.
//
// There are two causes (Eljdid, Aggoun and Youssef, see README.md). The surface that the missed pixel shows decides:
// 1. Find the nearest pixels with a point to the left and to the right, in the same view (or below the same lens).
// 2. Take the surface of the pixel that is farther from the viewer, because newly visible surfaces lie behind others.
// 3. Move the point of that surface at the missed pixel to both source frames.
// 4. If the point lies within the image of its view (or lens) in at least one source frame, the cause is "newly visible": a
//    nearer object hid the point there. Gaps of whole pixels in a stretched surface also count as newly visible.
// 5. If the point lies outside both images, the cause is "not covered". Pixels without neighbours also count as not covered.
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

struct SplatPair {
  const SplatSource &previous, &following;
  const Motion &back_to_previous, &back_to_following;  ///< motion from the in-between frame's moment to each source's moment
};

/// Counts the causes for the pixels in `missed` (ascending indices), and sets their colours if `film` is not null. The colour
/// is a mean of the nearest neighbours with a point, to the left, right, top and bottom in the same view (or lens), with
/// weights 1 / distance. Neighbours in front of the farthest surface are ignored. Without neighbours, the colour is the mean of
/// both sources at this pixel.
MissedCauses resolve_missed(const SplatPair& pair, const Splatter& splatter, const ViewSteps& steps,
                            std::span<const std::uint32_t> missed, const ThreadPool& pool, Image* film);

inline constexpr int kFillReach = 16;

}  // namespace lippmann
