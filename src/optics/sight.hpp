// Computes which point of the panel an eye sees through a point of the display plane z = 0.
//
// Each lens is a pinhole. The line from the eye to a point of a lens is moved, without changing its slope, to the centre of the
// lens, and continues straight to the panel. Outside the viewing zone, it ends in the cell of a neighbouring lens. For a
// cylindrical lens, the line is moved only across the lens.
#pragma once

#include "lippmann/optics/viewer.hpp"
#include "optics/lenticular.hpp"
#include "optics/microlens.hpp"

namespace lippmann {

struct PanelPoint {
  Vec2d pixel{0.0};
  /// Column and row of the lens through which the eye sees the point. In odd rows of a hexagonal array, 1/2 is added to the
  /// column. For a sheet, the row is 0.
  Vec2d lens{0.0};
};

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

struct QuiltPoint {
  /// In a camera grid, column and row of the view. In a cone of N views, (v, 0) with the index v of the view, which lies
  /// between -1/2 and N - 1/2. Eyes between two views have fractional indices. Views repeat beyond the ends of the cone.
  Vec2d view{0.0};
  Vec2d pixel{0.0};
  bool in_zone = true;
};

/// Maps an eye and a point of the plane z = 0 to a point of a quilt. A single view counts as a quilt of one view.
class QuiltSight {
 public:
  QuiltSight(const Panel& panel, const MultiView& views);
  QuiltSight(const Panel& panel, const SingleView& view);

  QuiltPoint seen_from(const Viewer& viewer, Vec2d point_mm) const;
  Vec2i views() const { return views_; }  ///< returns (columns, rows) of a camera grid, otherwise (number of views, 1)
  Vec2i tile_size() const { return tile_; }
  Vec2i tile_origin(Vec2i view) const;

 private:
  int columns_ = 1, panel_height_;
  Vec2i views_{1, 1};
  Vec2i tile_;
  Vec2d centre_px_;
  Vec2d pixel_mm_;
  double distance_, first_angle_ = 0.0, angle_step_ = 0.0, baseline_ = 0.0;
};

}  // namespace lippmann
