// Measures how far points of aligned images move from the first image to the last, and how much of this motion a display
// resolves.
#pragma once

#include <cstddef>
#include <vector>

#include "align/register_pictures.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

/// How far the nearest and the farthest points move to the left from the first image to the last, in pixels. Positive in front
/// of the display, negative behind it. The 2 % of the points with the largest and the 2 % with the smallest motion are ignored.
struct Parallax {
  double near_px = 0.0, far_px = 0.0;

  double total_px() const { return near_px - far_px; }
};

/// Measures the parallax by points that the middle image shares with other images. If the outermost images share none,
/// extrapolates from images nearer to the middle.
Parallax parallax_of(const RegisteredPictures& registered);

struct ShownParallax {
  double mm_per_px = 0.0;
  double lens_mm = 0.0;
  int views = 0;                 ///< number of views that the display can distinguish, at most one per image
  double resolved_lenses = 0.0;  ///< largest total motion without tearing: one lens from each view to the next
};

ShownParallax shown_parallax(const Display& display, Vec2i picture_size, std::size_t count);

}  // namespace lippmann
