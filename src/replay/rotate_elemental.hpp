// Converts orthoscopic images to pseudoscopic ones and back by rotating every elemental image by 180 degrees.
//
// Based on: Okano, Hoshino, Arai and Yuyama, "Real-time pickup method for a three-dimensional image based on integral
// photography", Appl. Opt. 36(7), 1997. A pixel at offset o from the centre of its cell has the ray x = l - o z / g, with the
// lens centre l and the gap g. Exchanging o and -o moves a point from depth z to depth -z. For lenticular sheets, each row of
// an elemental image is mirrored. For quilts, the order of the views is reversed.
#pragma once

#include <string>

#include "lippmann/optics/optics.hpp"
#include "replay/pixel_map.hpp"

namespace lippmann {

/// Returns the map that rotates all elemental images. At the panel's edge, a pixel becomes black if the pixel that it would
/// copy is outside the panel. Throws Error naming `where` if the number of pixels per lens is not whole.
PixelMap rotated_elemental_images(const Optics& optics, const std::string& where);

}  // namespace lippmann
