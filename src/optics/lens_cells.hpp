// The lens that the ray of a film pixel goes through, and the pixel's place below that lens: for lens arrays of any pitch,
// packing and slant, and for slanted panels.
//
// With the line x(z) = l + s z of a ray, `place` is l, in mm, and k = l / V + s, which is the same for all pixels at one place
// below their lenses (optics/view_place.hpp).
#pragma once

#include <optional>

#include "lippmann/core/math.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct LensCells {
  enum class Rows { kOfFilm, kSquare, kHexagonal };

  Rows rows = Rows::kOfFilm;  ///< kOfFilm: lenses are cylinders, and every row of the film has its own
  Vec2d lenses_per_mm{0.0};   ///< the column of a lens = its place . lenses_per_mm - first_lens
  double first_lens = 0.0;
  double rows_per_mm = 0.0, first_row_mm = 0.0;  ///< of lenses; y of row 0, rows count downwards
  Vec2d cell_px{1.0};                            ///< film pixels of a cell, along a row and down
  Vec2d px_per_k{0.0};
  /// A slanted panel's, whose rays start at their pixels instead of their lenses: full angle, parallax, and -1 where the phase
  /// falls to the right.
  double cone = 0.0, parallax = 1.0, sign = 1.0;

  struct Cell {
    Vec2i lens{0};         ///< column and row
    Vec2d in_cell{0.0};    ///< film pixels from a corner of the cell: 1 from each pixel below a lens to the next
    double in_lens = 0.0;  ///< how far the ray's place lies to the right of the lens's own, in lenses
  };
  /// row: the pixel's, in the film.
  Cell cell_of(Vec2d place, Vec2d k, int row) const;
};

/// Returns nothing for optics without lenses. `optics` must pass validate().
std::optional<LensCells> lens_cells(const Optics& optics);

}  // namespace lippmann
