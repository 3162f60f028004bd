// Measures whether errors are consistent from view to view and from frame to frame. docs/reference/metrics.md defines the
// metrics.
//
// An error that is equal in neighbouring views, or that moves with its surface, looks like a property of the scene. An error
// that changes is visible: as shimmer when the eye moves, or as flicker over time. Both metrics, angular consistency and
// flicker, measure only the change of the error.
#pragma once

#include <vector>

#include "lippmann/image/image.hpp"
#include "lippmann/layout/view_layout.hpp"

namespace lippmann {

/// Returns the PSNR, in dB, of the differences between neighbouring views. Neighbours are adjacent in a row or column of
/// `grid`. All views must have the same size. Returns infinity if all views have the same error, and NaN for a single view.
double angular_psnr_db(const std::vector<Image8>& reference, const std::vector<Image8>& test, ViewGrid grid);

/// One view at two consecutive times.
struct ViewChange {
  const Image8 &reference_before, &test_before, &reference, &test;
  /// 2 values per pixel of `reference`: how many pixels its point moved to the right and down since the earlier time.
  const float* motion;
};

struct FlickerSums {
  double squares = 0.0, weights = 0.0;
};

/// Returns the sum of squared changes of the error along the motion, in squared 8-bit steps, and the sum of the weights. Each
/// pixel has a weight of at most 1 per channel, and thus at most 3.
FlickerSums flicker_of_view(const ViewChange& change);

/// Returns the square root of the weighted mean of squared changes, in 8-bit steps. Returns NaN if no pixel can be followed.
double flicker_of(const FlickerSums& sums);

}  // namespace lippmann
