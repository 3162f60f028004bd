// A light field focused on a plane at depth z afterwards: what a lens as wide as the viewing zone would see sharp there.
//
// Shift and sum: Ng et al., "Light field photography with a hand-held plenoptic camera", Stanford CTSR 2005-02, here by the
// rays themselves. The ray of a pixel crosses z = 0 at c with slope t, so that it meets the plane at c + t z. Seen by the
// design viewer (slope e - s v through a point s of z = 0), that is the point
//   s = (c + (t - e) z) / (1 - v z)
// of the window. Every pixel gives its colour there, spread linearly over the distance to the next sample of its own view (one
// lens, or one pixel where there is none), and the sum is divided by the weights. Below whole pixels a view's samples all
// shift by the same amount, its spread samples are the view interpolated, and this is the mean of shifted views, for any
// fraction of a pixel; it stays right for slanted, hexagonal and fractional arrays, and quilts. A slanted panel's sub-pixels
// have one colour each: every colour is the mean of its own rays.
#pragma once

#include "lippmann/core/parallel.hpp"
#include "lippmann/optics/viewer.hpp"
#include "lippmann/replay/rendered_panel.hpp"

namespace lippmann {

/// Throws Error (usage) naming `flag` for a depth that is not finite, or not in front of the design viewer.
void validate_depth(const Optics& optics, double z_mm, const char* flag);

/// `z_mm` must be valid. size: pixels over the display's window, {0, 0}: natural_view_size (optics/viewing.hpp); all depths lie
/// on top of one another as the design viewer sees them. 3 channels, linear; black where no ray comes. The same bits for any
/// number of threads. `disagreement`, where given, receives how much the rays of each pixel differ: the variance of their
/// colours, summed over the channels (1 channel; infinite where no ray comes). Returns early, unfinished, when `context` is
/// cancelled.
Image refocus(const RenderedPanel& rendered, double z_mm, Vec2i size, const ThreadPool& pool, Image* disagreement = nullptr,
              const Context& context = {});

}  // namespace lippmann
