// Whether errors stay the same from view to view and from frame to frame; defined in docs/reference/metrics.md.
//
// An error that is the same in neighbouring views, or moves with the surface that it lies on, is seen as a property of the
// scene; one that differs is seen as shimmer when the eye moves, or as flicker. Both figures are of the error's change alone.
#pragma once

#include <vector>

#include "lippmann/image/image.hpp"
#include "lippmann/layout/view_layout.hpp"

namespace lippmann {

/// PSNR, in dB, of the differences between views next to each other, across and up. Views are those of `grid`, of one size.
/// Infinite where the error is the same in all views; NaN of a single view.
double angular_psnr_db(const std::vector<Image8>& reference, const std::vector<Image8>& test, ViewGrid grid);

/// One view at two consecutive times.
struct ViewChange {
  const Image8 &reference_before, &test_before, &reference, &test;
  const float* motion;  ///< 2 samples a pixel of `reference`: how far its point has moved, right and down
};

struct FlickerSums {
  double squares = 0.0, weights = 0.0;
};

/// The weighted sum of squared changes of the error along motion, in codes, and of the weights (3 for each pixel at most).
FlickerSums flicker_of_view(const ViewChange& change);

/// The root of the mean, in codes; NaN where nothing can be followed.
double flicker_of(const FlickerSums& sums);

}  // namespace lippmann
