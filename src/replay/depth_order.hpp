// Whether two eyes see depth the right way round: what is behind the display has to move with the eye, what is before it
// against.
//
// From eye E to eye E + b along x a point at depth z moves by -b z / (E_z - z) over the plane z = 0, as views are laid out here
// (replay/eye_view.hpp). Where the true depth of every pixel is known, each has its counterpart in the other eye's view at that
// distance. In pseudoscopic pictures it lies at the same distance on the other side. Which of the two is more alike?
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

struct DepthOrder {
  double behind_db = 0.0, front_db = 0.0;   ///< how much less the squared difference is on the right side than on the wrong
                                            ///< one; above 0: the right way round
  int behind_pixels = 0, front_pixels = 0;  ///< that tell: moved by at least a pixel, both counterparts within the picture
};

/// `view` and `other` from eyes at distance eye_z_mm, the other one baseline_mm to the right; `depth`: 1 channel, mm, of what
/// `view` should see, not finite: nothing. One size, pixel_mm wide in the plane z = 0.
DepthOrder measure_depth_order(const Image& view, const Image& other, const Image& depth, double eye_z_mm, double baseline_mm,
                               double pixel_mm);

}  // namespace lippmann
