// Encodes depth for a page as disparity codes in the pixels of an image.
//
// Two eyes at distance V look at the display at slopes that differ by d. From one eye to the other, a point at depth z moves by
// d w in the plane z = 0, where w = z V / (V - z), or w = z for eyes at infinity. A code stores w, with even steps near the
// plane and ever larger steps away from it:
//   code = 1 + round(65534 (t + 1) / 2),  t = w / (|w| + scale)
// in red (high byte) and green (low byte); blue is 0. Code 0 means that there is no surface.
#pragma once

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Returns the disparity w (top of this file) at depth z. vergence: 1 / V, per mm. parallax: shown depth / true depth.
double disparity_mm(double z_mm, double vergence, double parallax);

/// Returns the disparity w of each pixel. depth: z in mm of the display frame. Pixels without a surface (z = -inf) move like
/// infinitely far points: w = -V, or -inf if V is infinite.
Image disparities_mm(const Image& depth, double vergence, double parallax);

/// Encodes disparities. Values that are not finite get code 0. scale_mm > 0.
Image8 disparity_codes(const Image& disparities, double scale_mm);

}  // namespace lippmann
