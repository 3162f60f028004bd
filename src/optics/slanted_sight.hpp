// Which sub-pixels of a calibrated slanted panel an eye sees at a point of the display plane.
//
// The lens above the point is the whole part of its phase. All over it, it shows the eye the one place below it whose direction
// is the eye's: where the eye's line meets the plane of the viewer, at (x_D, D), atan(x_D / D) = cone (v - 1/2), and the phase
// has the fraction 1 - v (or v). Beyond the cone, directions repeat. The three colours of that place are those of three pixels.
#pragma once

#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/viewer.hpp"

namespace lippmann {

struct SlantedPoint {
  double lens = 0.0;      ///< whole part of the phase
  double fraction = 0.5;  ///< the rest of the phase, at the place below the lens that the eye sees
  bool in_zone = true;
};

/// Rows are counted from the top.
class SlantedSight {
 public:
  SlantedSight(const Panel& panel, const SlantedPanel& slanted);

  Vec2i size() const { return size_; }  ///< the panel's

  /// A point of the plane z = 0 in continuous pixel coordinates.
  Vec2d pixel_at(Vec2d point_mm) const;

  /// What is seen at a point of the plane, in the panel's row `row`.
  SlantedPoint seen_from(const Viewer& viewer, Vec2d point_mm, int row) const;

  /// In which column, fractional (+ 0.5 is its centre), the sub-pixel of that colour lies whose phase that is, in a row.
  double column_of(const SlantedPoint& point, int color, int row, double near_column) const;

  /// The lens that the sub-pixel of a colour belongs to.
  double lens_of(int column, int row, int color) const;

 private:
  Vec2f offset(double column, int row, int color) const;  ///< from a pixel's centre to its sub-pixel, pixels, y up
  double phase(double column, double up) const { return column * per_column_ + up * per_row_ - center_; }

  Vec2i size_;
  double pixel_mm_, per_column_, per_row_, center_, cone_, distance_;
  bool inverted_;
  SubPixelOffsets sub_pixels_;
};

}  // namespace lippmann
