// Measures whether two eye views show depth in the right order: points behind the display move with the eye, points in front
// against it.
//
// If the eye moves from E to E + b along x, the image of a point at depth z moves by -b z / (E.z - z) in the plane z = 0
// (layout as in replay/eye_view.hpp). The depth of a pixel therefore determines where the same point is in the other view. In
// pseudoscopic images the point is displaced by the same distance to the opposite side. The measure compares a pixel with the
// other view at both positions.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

struct DepthOrder {
  /// By how many dB the squared difference is lower on the expected side than on the opposite side, for points behind and in
  /// front of the display. Above 0, the depth order is right.
  double behind_db = 0.0, front_db = 0.0;
  /// Number of pixels compared: those that shift by at least a pixel and have both positions inside the image.
  int behind_pixels = 0, front_pixels = 0;
};

/// Compares `view` with `other`, seen from an eye baseline_mm further to the right. All images have one size. depth: depth in
/// mm of the points that `view` should show, 1 channel; values that are not finite mean no point. eye_z_mm: distance of both
/// eyes. pixel_mm: width of a pixel in the plane z = 0.
DepthOrder measure_depth_order(const Image& view, const Image& other, const Image& depth, double eye_z_mm, double baseline_mm,
                               double pixel_mm);

}  // namespace lippmann
