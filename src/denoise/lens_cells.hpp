// The lens that the ray of a pixel goes through, and the pixel's place below that lens: for lens arrays of any pitch, packing
// and slant, and for slanted panels.
#pragma once

#include <optional>

#include "lippmann/core/math.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Place: where a ray crosses z = 0, mm. k: the slope towards which it leaves for the viewer's plane, place / V + slope
/// (sorted_views.hpp).
class LensCells {
 public:
  /// None for optics without lenses, and for lenses narrower than a pixel of the film.
  static std::optional<LensCells> of(const Optics& optics);

  struct Cell {
    Vec2i lens{0};         ///< column and row; rows count downwards, and are the film's where lenses are cylinders
    Vec2d in_cell{0.0};    ///< film pixels from a corner of the cell: 1 from each pixel below a lens to the next
    double in_lens = 0.0;  ///< how far the pixel's place lies to the right of the lens's own, in lenses
  };
  /// row: the pixel's, in the film.
  Cell cell_of(Vec2d place, Vec2d k, int row) const;

 private:
  enum class Kind { kSheet, kSquare, kHexagonal, kSlantedPanel };
  Kind kind_ = Kind::kSheet;
  Vec2d lenses_per_mm_{0.0};  ///< lens column = place . lenses_per_mm - first_lens, without in_lens
  double first_lens_ = 0.0;
  double rows_per_mm_ = 0.0, first_row_mm_ = 0.0;    ///< of lenses
  Vec2d cell_px_{1.0}, px_per_k_{0.0};               ///< a lens array's
  double cone_ = 0.0, parallax_ = 1.0, sign_ = 1.0;  ///< a slanted panel's
};

}  // namespace lippmann
