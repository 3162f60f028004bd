// Maps an eye and a point of the display plane to the sub-pixels of a calibrated slanted panel that the eye sees there.
//
// The lens above the point is the whole part of its phase. Over its full width, it shows the eye a single place below it: the
// one whose direction is the eye's. If the eye's line meets the plane of the viewer at (x_D, D), then atan(x_D / D) = cone (v -
// 1/2), and the fraction of the phase is 1 - v (or v). Directions repeat beyond the cone. The three colours of that place are
// sub-pixels of three different pixels.
#pragma once

#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/viewer.hpp"

namespace lippmann {

struct SlantedPoint {
  double lens = 0.0;      ///< whole part of the phase
  double fraction = 0.5;  ///< fraction of the phase at the place below the lens that the eye sees
  bool in_zone = true;
};

/// Rows count from the top.
class SlantedSight {
 public:
  SlantedSight(const Panel& panel, const SlantedPanel& slanted);

  Vec2i size() const { return size_; }  ///< of the panel

  /// Returns a point of the plane z = 0 in continuous pixel coordinates.
  Vec2d pixel_at(Vec2d point_mm) const;

  /// Returns what the eye sees at a point of the plane, in the panel's row `row`.
  SlantedPoint seen_from(const Viewer& viewer, Vec2d point_mm, int row) const;

  /// Returns the fractional column (its centre is at + 0.5) of the sub-pixel with this colour and phase in a row.
  double column_of(const SlantedPoint& point, int color, int row, double near_column) const;

  /// Returns the lens of a sub-pixel.
  double lens_of(int column, int row, int color) const;

 private:
  Vec2f offset(double column, int row, int color) const;  ///< from a pixel's centre to its sub-pixel, in pixels, y up
  double phase(double column, double up) const { return column * per_column_ + up * per_row_ - center_; }

  Vec2i size_;
  double pixel_mm_, per_column_, per_row_, center_, cone_, distance_;
  bool inverted_;
  SubPixelOffsets sub_pixels_;
};

}  // namespace lippmann
