// The disparity of pixels on the edge of something near: that of what is near.
//
// Layers have the depth that a pixel's middle has. A pixel whose samples meet two surfaces shows a mixture of both colours,
// which a page would move with the farther surface wherever the middle meets that one: an outline of what is near would float
// over what is far. So such a pixel moves with what is near, and what is far is seen beside it.
#pragma once

#include "lippmann/image/image.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

/// The least difference of disparities, mm, that moves a pixel of views of that size by half a pixel from one view to the next.
double visible_jump_mm(const PageFacts& facts, Vec2i view_size);

/// `disparities`: 1 channel, views of that size as tiles. Each pixel takes the disparity of the nearest of its eight neighbours
/// in its view, if that is nearer by at least `jump_mm`. What is not finite is nowhere or infinitely far, and no neighbour
/// takes it.
void take_near_at_edges(Image& disparities, Vec2i view_size, double jump_mm);

}  // namespace lippmann
