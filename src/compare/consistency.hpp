// Measures whether errors are consistent from view to view and from frame to frame. docs/reference/metrics.md defines the
// metrics.
//
// An error that is equal in neighbouring views, or that moves with its surface, looks like a property of the scene. An error
// that changes is visible as shimmer when the eye moves, or as flicker over time.
#pragma once

#include <vector>

#include "lippmann/image/image.hpp"
#include "lippmann/layout/view_layout.hpp"

namespace lippmann {

/// Returns the PSNR in dB of the differences between adjacent views of `grid`. All views must have the same size. Returns
/// infinity if all views have the same error, and NaN for a single view.
double angular_psnr_db(const std::vector<Image8>& reference, const std::vector<Image8>& test, ViewGrid grid);

struct ViewChange {
  const Image8 &reference_before, &test_before, &reference, &test;
  /// Two values per pixel of `reference`: the motion to the right and down since the earlier time, in pixels.
  const float* motion;
};

struct FlickerSums {
  double squares = 0.0, weights = 0.0;
};

/// Returns the weighted sum of squared changes of the error along the motion, in squared 8-bit codes, and the sum of the
/// weights.
FlickerSums flicker_of_view(const ViewChange& change);

/// Returns the root of the weighted mean of the squared changes, in 8-bit codes. Returns NaN if the weights sum to 0.
double flicker_of(const FlickerSums& sums);

}  // namespace lippmann
