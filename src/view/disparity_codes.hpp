// Depth as a page needs it: how far a point moves between views, as codes in the pixels of a picture.
//
// Seen from a distance V by eyes whose slopes differ by d, a point at depth z moves by d w in the plane z = 0, with
// w = z V / (V - z); w = z for views from infinitely far. A code says w, evenly near the plane and ever more coarsely away from
// it:
//   code = 1 + round(65534 (t + 1) / 2),  t = w / (|w| + scale)
// in red (its upper byte) and green (its lower byte); blue is 0. Code 0: nothing is there.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

/// w of a depth; `parallax`: shown depth / true depth.
double disparity_mm(double z_mm, double vergence, double parallax);

/// `depth`: 1 channel, z in mm of the display frame. Where nothing is there (-inf), pixels show the surroundings, which move
/// between views as the infinitely far does: w = -V, or -inf if V is infinite.
Image disparities_mm(const Image& depth, double vergence, double parallax);

/// `disparities`: 1 channel; what is not finite gets code 0. scale_mm > 0.
Image8 disparity_codes(const Image& disparities, double scale_mm);

}  // namespace lippmann
