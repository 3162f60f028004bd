// Measures how far points of aligned images move from the first image to the last, and how much of that a display resolves.
#pragma once

#include <cstddef>
#include <vector>

#include "align/register_pictures.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

/// Motion of the nearest and the farthest points to the left, from the first image to the last, in pixels: positive in front of
/// the display, negative behind it. The outermost 2 % of the points at either end are ignored.
struct Parallax {
  double near_px = 0.0, far_px = 0.0;

  double total_px() const { return near_px - far_px; }
};

/// Measures the parallax from points shared with the middle image, in the outermost images that have such points.
Parallax parallax_of(const RegisteredPictures& registered);

/// The parallax of images that fill a display, cropped to its shape.
struct ShownParallax {
  double mm_per_px = 0.0;
  double lens_mm = 0.0;  ///< width of a lens
  int views = 0;         ///< number of views that the display can distinguish, at most one per image
  double resolved_lenses =
      0.0;  ///< largest motion without visible tearing, in front or behind, in lenses: one lens per view step
};

ShownParallax shown_parallax(const Display& display, Vec2i picture_size, std::size_t count);

}  // namespace lippmann
