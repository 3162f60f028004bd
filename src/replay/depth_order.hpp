// Measures whether two eye views show depth in the right order: points behind the display move with the eye, points in front
// against it.
//
// If the eye moves from E to E + b along x, the image of a point at depth z moves by -b z / (E.z - z) in the plane z = 0
// (layout as in replay/eye_view.hpp). In pseudoscopic images, it moves as far to the opposite side. Each pixel is compared with
// the other view at both positions.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

struct DepthOrder {
  /// Squared difference at the opposite position divided by the squared difference at the expected position, in dB, for points
  /// behind and in front of the display. A positive value means that the depth order is right.
  double behind_db = 0.0, front_db = 0.0;
  /// Number of compared pixels. They move by at least a pixel, and both of their positions are inside the image.
  int behind_pixels = 0, front_pixels = 0;
};

/// `other` is seen from an eye baseline_mm to the right of the eye of `view`, at the same distance eye_z_mm. `depth` holds the
/// depth in mm of the points that `view` should show, or a non-finite value. `pixel_mm`: width of a pixel in the plane z = 0.
DepthOrder measure_depth_order(const Image& view, const Image& other, const Image& depth, double eye_z_mm, double baseline_mm,
                               double pixel_mm);

}  // namespace lippmann
