// Refocuses a light field on a plane at depth z, like a lens as wide as the viewing zone.
//
// Based on: Ng et al., "Light field photography with a hand-held plenoptic camera", Stanford CTSR 2005-02 (shift and sum),
// formulated by rays. The ray of a pixel crosses z = 0 at c with slope t and meets the plane of focus at c + t z. The intended
// viewer, at the distance 1 / v, sees a point s of the plane z = 0 along a ray of slope e - s v, where e is the slope of the
// ray through the origin. The viewer therefore sees the point in focus at
//   s = (c + (t - e) z) / (1 - v z).
// Each pixel adds its colour at s, spread by a tent filter. The tent is as wide as the distance to the next sample of the
// pixel's view (one lens, or one pixel if there are no lenses). The sum is divided by the weights.
//
// The sub-pixels of a slanted panel have one colour channel each, so each channel is averaged over the rays of its own
// sub-pixels.
#pragma once

#include "lippmann/core/parallel.hpp"
#include "lippmann/optics/viewer.hpp"
#include "lippmann/replay/rendered_panel.hpp"

namespace lippmann {

/// Throws a usage Error naming `flag` if the depth is not finite, or if it is not in front of the intended viewer.
void validate_depth(const Optics& optics, double z_mm, const char* flag);

/// Returns the image focused at z_mm, in linear light, and black where no ray arrives. z_mm must pass validate_depth(). `size`
/// is the size of the image in pixels; {0, 0} means natural_view_size() (optics/viewing.hpp). `disagreement`, if not null,
/// receives the variance of the colours of each pixel's rays, summed over the channels (infinite where no ray arrives). The
/// image is unfinished if `context` is cancelled.
Image refocus(const RenderedPanel& rendered, double z_mm, Vec2i size, const ThreadPool& pool, Image* disagreement = nullptr,
              const Context& context = {});

}  // namespace lippmann
