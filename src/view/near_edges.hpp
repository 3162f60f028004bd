// Gives pixels on the edge of a near object the disparity of that object.
//
// A depth layer stores the depth at the centre of a pixel. A pixel that covers two surfaces shows a mixture of both colours. If
// its centre is on the farther surface, a page would move the pixel with that surface, and an outline of the near object would
// float over the background. Such pixels therefore get the disparity of the near object.
#pragma once

#include "lippmann/image/image.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

/// Returns the difference of disparities, in mm, that moves a pixel by half a pixel from one view to the next. The views have
/// view_size pixels.
double visible_jump_mm(const PageFacts& facts, Vec2i view_size);

/// Compares each pixel with its eight neighbours in the view. If the nearest of them is nearer by at least jump_mm, the pixel
/// gets that neighbour's disparity. disparities: 1 channel, views of view_size as tiles. Neighbours without a finite disparity
/// are ignored.
void spread_near_disparities(Image& disparities, Vec2i view_size, double jump_mm);

}  // namespace lippmann
