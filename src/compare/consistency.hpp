// Measures the consistency of errors from view to view and from frame to frame; defined in docs/reference/metrics.md.
//
// An error that is equal in neighbouring views, or that moves with its surface, looks like a property of the scene. An error
// that changes is visible as shimmer when the eye moves, or as flicker. The two figures, angular consistency and flicker,
// measure only the change of the error.
#pragma once

#include <vector>

#include "lippmann/image/image.hpp"
#include "lippmann/layout/view_layout.hpp"

namespace lippmann {

/// Returns the PSNR, in dB, of the differences between views that are neighbours in a row or column of `grid`. All views have
/// one size. Infinite if all views have the same error; NaN for a single view.
double angular_psnr_db(const std::vector<Image8>& reference, const std::vector<Image8>& test, ViewGrid grid);

/// One view at two consecutive times.
struct ViewChange {
  const Image8 &reference_before, &test_before, &reference, &test;
  const float* motion;  ///< 2 samples per pixel of `reference`: how far its point moved since the earlier time, right and down
};

struct FlickerSums {
  double squares = 0.0, weights = 0.0;
};

/// Returns the sum of squared changes of the error along motion, in codes, weighted for each sample, and the sum of the weights
/// (at most 3 per pixel).
FlickerSums flicker_of_view(const ViewChange& change);

/// Returns the root of the weighted mean of squared changes, in codes; NaN if no pixel can be followed.
double flicker_of(const FlickerSums& sums);

}  // namespace lippmann
