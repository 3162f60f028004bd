// Assigns pixels on the edge of a near object to that object's disparity.
//
// Layers store the depth at the centre of a pixel. A pixel that covers two surfaces shows a mixture of both colours. If its
// centre is on the farther surface, a page would move it with that surface, and an outline of the near object would float over
// the background. Such pixels therefore take the disparity of the near object.
#pragma once

#include "lippmann/image/image.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

/// Returns the smallest difference of disparities, in mm, that moves a pixel of views of that size by half a pixel from one
/// view to the next.
double visible_jump_mm(const PageFacts& facts, Vec2i view_size);

/// Gives each pixel the disparity of the nearest of its eight neighbours in its view if that is nearer by at least jump_mm.
/// disparities: 1 channel, views of view_size as tiles. Neighbours without a finite disparity are ignored.
void spread_near_disparities(Image& disparities, Vec2i view_size, double jump_mm);

}  // namespace lippmann
