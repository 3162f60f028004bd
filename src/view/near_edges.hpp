// Gives pixels on the edge of a near object the disparity of that object.
//
// A pixel that covers two surfaces shows both colours, but has the depth at its centre. If the centre is on the farther
// surface, a page would move an outline of the near object with the background.
#pragma once

#include "lippmann/image/image.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

/// Returns the difference of disparities, in mm, that moves a pixel by half a pixel from view to view. Views have view_size
/// pixels.
double visible_jump_mm(const PageFacts& facts, Vec2i view_size);

/// If the nearest of a pixel's eight neighbours is nearer by at least jump_mm, the pixel gets its disparity. disparities: views
/// of view_size as tiles. Neighbours without a finite disparity do not count.
void spread_near_disparities(Image& disparities, Vec2i view_size, double jump_mm);

}  // namespace lippmann
