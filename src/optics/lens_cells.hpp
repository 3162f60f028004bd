// Maps the ray of a film pixel to its lens and to the pixel's position below that lens, for slanted panels and for lens arrays
// of any pitch, packing and slant.
//
// For a ray x(z) = l + s z, `place` is l in mm, and k = l / V + s, which is equal for all pixels at the same position below
// their lenses (optics/view_place.hpp).
// below their lenses (optics/view_place.hpp).
#pragma once

#include <optional>

#include "lippmann/core/math.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct LensCells {
  enum class Rows { kOfFilm, kSquare, kHexagonal };

  Rows rows = Rows::kOfFilm;  ///< kOfFilm: cylindrical lenses; each film row has its own row
  Vec2d lenses_per_mm{0.0};   ///< column of a lens = place . lenses_per_mm - first_lens
  double first_lens = 0.0;
  double rows_per_mm = 0.0, first_row_mm = 0.0;  ///< lens rows; first_row_mm is y of row 0, rows count downwards
  Vec2d cell_px{1.0};                            ///< size of a cell in film pixels, along a row and down
  Vec2d px_per_k{0.0};
  /// For slanted panels, whose rays start at their pixels instead of their lenses: full cone angle, parallax, and -1 if the
  /// phase decreases to the right.
  double cone = 0.0, parallax = 1.0, sign = 1.0;

  struct Cell {
    Vec2i lens{0};         ///< column and row
    Vec2d in_cell{0.0};    ///< film pixels from the corner of the cell, in steps of 1 per pixel below a lens
    double in_lens = 0.0;  ///< distance of `place` to the right of the lens centre, in lenses
  };
  /// Returns the cell of a ray. `row`: film row of the pixel.
  Cell cell_of(Vec2d place, Vec2d k, int row) const;
};

/// Returns the mapping; none for optics without lenses. `optics` must pass validate().
std::optional<LensCells> lens_cells(const Optics& optics);

}  // namespace lippmann
