// Measures whether two eye views show depth in the right order: points behind the display move with the eye, points in front
// against it.
//
// From eye E to eye E + b along x, a point at depth z moves by -b z / (E_z - z) over the plane z = 0, in the layout of
// replay/eye_view.hpp. With known depths, the counterpart of each pixel in the other view is at this distance. In pseudoscopic
// images it is at the same distance on the other side. The measure compares both candidates.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

struct DepthOrder {
  double behind_db = 0.0, front_db = 0.0;  ///< by how much the squared difference is lower on the right side than on the wrong
                                           ///< side; above 0: the right order
  int behind_pixels = 0,
      front_pixels = 0;  ///< number of pixels compared: shifted by at least a pixel, with both candidates inside the image
};

/// Compares `view` with `other`, which is seen from baseline_mm further right. All images have one size. depth: depth of what
/// `view` should show, 1 channel, mm; not finite: nothing. eye_z_mm: distance of both eyes. pixel_mm: width of a pixel in the
/// plane z = 0.
DepthOrder measure_depth_order(const Image& view, const Image& other, const Image& depth, double eye_z_mm, double baseline_mm,
                               double pixel_mm);

}  // namespace lippmann
