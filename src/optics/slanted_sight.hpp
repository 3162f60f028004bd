// Maps an eye and a point of the display plane to the sub-pixels of a calibrated slanted panel that the eye sees there.
//
// The index of the lens above a point is the whole part of its phase. Over its full width, the lens shows the eye a single
// point below it: the point that it images into the direction of the eye. If the line from the eye meets the plane of the
// viewer at (x_D, D), then atan(x_D / D) = cone (v - 1/2), and the fraction of the phase is 1 - v (or v). Directions repeat
// beyond the cone. The three colours of the point below the lens are sub-pixels of three different pixels.
#pragma once

#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/viewer.hpp"

namespace lippmann {

struct SlantedPoint {
  double lens = 0.0;      ///< index of the lens: the whole part of the phase
  double fraction = 0.5;  ///< fraction of the phase at the point below the lens that the eye sees
  bool in_zone = true;
};

/// Maps eyes to the sub-pixels they see. Rows count from the top.
class SlantedSight {
 public:
  SlantedSight(const Panel& panel, const SlantedPanel& slanted);

  Vec2i size() const { return size_; }  ///< size of the panel in pixels

  /// Returns the continuous pixel coordinates of a point of the plane z = 0.
  Vec2d pixel_at(Vec2d point_mm) const;

  /// Returns the point below the lens that the eye sees through a point of the plane, on the panel's row `row`.
  SlantedPoint seen_from(const Viewer& viewer, Vec2d point_mm, int row) const;

  /// Returns the column in a row, as a fraction (its centre is at + 0.5), of the sub-pixel with this colour and phase.
  double column_of(const SlantedPoint& point, int color, int row, double near_column) const;

  /// Returns the index of the lens above a sub-pixel.
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
