// Which point of a panel an eye sees at a point of the display plane, through the array's own lenses.
//
// Pinhole per lens: the eye's line that crosses z = 0 below a lens is taken through that lens's centre instead, and goes on
// straight to the panel. Where it meets the panel decides, whichever lens's cell that is in: outside the viewing zone it is a
// neighbour's, and the picture flips. A cylindrical lens has a centre only across; along it the line keeps its own place.
#pragma once

#include "lippmann/optics/viewer.hpp"
#include "optics/lenticular.hpp"
#include "optics/microlens.hpp"

namespace lippmann {

/// A point of the panel behind a lens array.
struct PanelPoint {
  Vec2d pixel{0.0};  ///< continuous pixel coordinates; may lie outside the panel
  Vec2d lens{0.0};   ///< that the eye looks through; hexagonal: half steps in odd rows; a sheet's second number is 0
};

/// The cell that a point of the panel lies in, numbered as lenses are.
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

/// A point of a quilt: which view, and where in its tile.
struct QuiltPoint {
  Vec2d view{0.0};   ///< column and row of views (of a cone: view and 0), whole numbers are views' own eyes. Beyond a cone its
                     ///< views repeat, so that this is from -1/2 to N - 1/2; beyond a camera grid there is nothing else
  Vec2d pixel{0.0};  ///< within the tile, origin top left
  bool in_zone = true;
};

/// A single view is a quilt of one.
class QuiltSight {
 public:
  QuiltSight(const Panel& panel, const MultiView& views);
  QuiltSight(const Panel& panel, const SingleView& view);

  QuiltPoint seen_from(const Viewer& viewer, Vec2d point_mm) const;
  Vec2i views() const { return views_; }  ///< columns and rows of a camera grid; else all in one row
  Vec2i tile_size() const { return tile_; }
  Vec2i tile_origin(Vec2i view) const;  ///< its top left pixel

 private:
  int columns_ = 1, panel_height_;  ///< columns of tiles; the panel's height in pixels
  Vec2i views_{1, 1};
  Vec2i tile_;
  Vec2d centre_px_;  ///< where the origin of the plane z = 0 lies within a tile
  Vec2d pixel_mm_;
  double distance_, first_angle_ = 0.0, angle_step_ = 0.0, baseline_ = 0.0;
};

}  // namespace lippmann
