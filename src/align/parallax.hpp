// How far places of aligned pictures move from the first picture to the last, and what a display resolves of that.
#pragma once

#include <cstddef>
#include <vector>

#include "align/register_pictures.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

/// How far the nearest and the farthest places move to the left from the first picture to the last, pixels: above 0 in front of
/// the display, below 0 behind it. 2 % of the places at either end are left out.
struct Parallax {
  double near_px = 0.0, far_px = 0.0;

  double total_px() const { return near_px - far_px; }
};

/// Measured on places that pictures share with the middle one, in the outermost pictures that share some.
Parallax parallax_of(const RegisteredPictures& registered);

/// The parallax of pictures that fill a display, cropped to its shape.
struct ShownParallax {
  double mm_per_px = 0.0;
  double lens_mm = 0.0;          ///< the width of a lens
  int views = 0;                 ///< what the display can tell apart, at most one per picture
  double resolved_lenses = 0.0;  ///< of a place in front or behind: one lens from view to view; more looks torn
};

ShownParallax shown_parallax(const Display& display, Vec2i picture_size, std::size_t count);

}  // namespace lippmann
