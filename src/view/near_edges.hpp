// Gives pixels on the edge of a near object the disparity of that object.
//
// A pixel that covers two surfaces shows both colours, but has the depth at its centre. If the centre is on the farther
// surface, a page would move an outline of the near object with the background.
#pragma once

#include "lippmann/image/image.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

/// Returns the difference of disparities, in mm, that shifts two points by half a pixel relative to each other between
/// neighbouring views. view_size: pixels of a view.
double visible_jump_mm(const PageFacts& facts, Vec2i view_size);

/// Gives each pixel the disparity of the nearest of its eight neighbours, if this neighbour is nearer by at least jump_mm.
/// `disparities` holds the views as tiles of view_size pixels. Neighbours without a finite disparity do not count.
void spread_near_disparities(Image& disparities, Vec2i view_size, double jump_mm);

}  // namespace lippmann
