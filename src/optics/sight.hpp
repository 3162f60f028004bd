// Maps an eye and a point of the display plane to the panel point that the eye sees through the array at that point.
//
// Each lens is modelled as a pinhole: the line from the eye that crosses z = 0 at a point of a lens is moved to the lens's
// centre and continues straight to the panel. Outside the viewing zone, it ends in the cell of a neighbouring lens, and the
// picture flips. A cylindrical lens has a centre only in the direction across it; along the lens, the line keeps its position.
#pragma once

#include "lippmann/optics/viewer.hpp"
#include "optics/lenticular.hpp"
#include "optics/microlens.hpp"

namespace lippmann {

/// A point of the panel behind a lens array.
struct PanelPoint {
  Vec2d pixel{0.0};  ///< continuous pixel coordinates; may lie outside the panel
  /// Column and row of the lens that the point is seen through. Columns in odd hexagonal rows are k + 1/2; for a sheet, the row
  /// is 0.
  Vec2d lens{0.0};
};

/// The column and row of the cell of a panel point, numbered like the lenses.
using CellOf = Vec2d;

class LenticularSight {
 public:
  LenticularSight(const Panel& panel, const LenticularSheet& sheet) : c_(make_lenticular(panel, sheet, 0.0)) {}

  PanelPoint seen_from(const Viewer& viewer, Vec2d point_mm) const;
  CellOf cell(Vec2d pixel) const { return {cell_of(c_.axis, pixel.x * c_.cosine - pixel.y * c_.sine), 0.0}; }

 private:
  LenticularConstants<double> c_;
};

class MicrolensSight {
 public:
  MicrolensSight(const Panel& panel, const MicrolensArray& array)
      : c_(make_microlens(panel, array, 0.0)), hexagonal_(array.packing == LensPacking::kHexagonal) {}

  PanelPoint seen_from(const Viewer& viewer, Vec2d point_mm) const;
  CellOf cell(Vec2d pixel) const;

 private:
  MicrolensConstants<double> c_;
  bool hexagonal_;
};

/// A point of a quilt: its view, and its position in the tile.
struct QuiltPoint {
  /// Column and row of views; for a cone of views, the view and 0. Whole numbers are the views' eyes. Cones repeat beyond their
  /// ends, so that values are within -1/2 to N - 1/2; camera grids do not repeat.
  Vec2d view{0.0};
  Vec2d pixel{0.0};  ///< position within the tile, with its origin at the top left
  bool in_zone = true;
};

/// The sight of a quilt. A single view counts as a quilt of one view.
class QuiltSight {
 public:
  QuiltSight(const Panel& panel, const MultiView& views);
  QuiltSight(const Panel& panel, const SingleView& view);

  QuiltPoint seen_from(const Viewer& viewer, Vec2d point_mm) const;
  Vec2i views() const { return views_; }  ///< number of columns and rows of a camera grid; otherwise one row
  Vec2i tile_size() const { return tile_; }
  Vec2i tile_origin(Vec2i view) const;  ///< returns the top left pixel of a view's tile

 private:
  int columns_ = 1, panel_height_;  ///< number of columns of tiles; height of the panel in pixels
  Vec2i views_{1, 1};
  Vec2i tile_;
  Vec2d centre_px_;  ///< position within a tile of the point x = y = 0 of the plane z = 0
  Vec2d pixel_mm_;
  double distance_, first_angle_ = 0.0, angle_step_ = 0.0, baseline_ = 0.0;
};

}  // namespace lippmann
