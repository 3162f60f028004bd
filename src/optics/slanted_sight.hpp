// Computes which sub-pixels of a calibrated slanted panel an eye sees through a point of the display plane.
//
// 1. The whole part of the phase at the point is the index of the lens.
// 2. Over its full width, the lens shows the eye a single point below the lens: the point whose light goes towards the eye.
// 3. The line from the eye through the point of the display plane meets the plane z = D (D is distance_mm) at x_D. The view v
//    of this direction follows from atan(x_D / D) = cone (v - 1/2). Views repeat beyond the cone.
// 4. The point below the lens has the phase fraction 1 - v, or v if the panel is not inverted. Its three colours are sub-pixels
//    of up to three different pixels.
#pragma once

#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/viewer.hpp"

namespace lippmann {

struct SlantedPoint {
  double lens = 0.0;
  double fraction = 0.5;
  bool in_zone = true;
};

/// Maps eyes to the sub-pixels that they see. Rows count from the top.
class SlantedSight {
 public:
  SlantedSight(const Panel& panel, const SlantedPanel& slanted);

  Vec2i size() const { return size_; }

  Vec2d pixel_at(Vec2d point_mm) const;

  /// Returns the point below the lens that the eye sees through a point of the plane z = 0, in the panel's row `row`.
  SlantedPoint seen_from(const Viewer& viewer, Vec2d point_mm, int row) const;

  /// Returns the position along a row, in continuous pixel coordinates, of the pixel whose sub-pixel of this colour has the
  /// phase of `point`. `near_column` is an estimate of the result.
  double column_of(const SlantedPoint& point, int color, int row, double near_column) const;

  double lens_of(int column, int row, int color) const;

 private:
  /// Returns the offset of a sub-pixel from its pixel's centre, in pixels, y up.
  Vec2f offset(double column, int row, int color) const;
  double phase(double column, double up) const { return column * per_column_ + up * per_row_ - center_; }

  Vec2i size_;
  double pixel_mm_, per_column_, per_row_, center_, cone_, distance_;
  bool inverted_;
  SubPixelOffsets sub_pixels_;
};

}  // namespace lippmann
