// Maps the ray of a film pixel to its lens and to the pixel's position below that lens, for slanted panels and for lens arrays
// of any pitch, packing and slant.
//
// For a ray x(z) = l + s z, `place` is l in mm, and k = l / V + s, which is equal for all pixels at the same position below
// their lenses (optics/view_place.hpp).
#pragma once

#include <optional>

#include "lippmann/core/math.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct LensCells {
  enum class Rows { kOfFilm, kSquare, kHexagonal };

  Rows rows = Rows::kOfFilm;  ///< kOfFilm: for cylindrical lenses; each row of the film is a row of lenses
  Vec2d lenses_per_mm{0.0};   ///< the column of a lens is dot(place, lenses_per_mm) - first_lens
  double first_lens = 0.0;
  double rows_per_mm = 0.0, first_row_mm = 0.0;  ///< rows of lenses; first_row_mm is the y of row 0, rows count downwards
  Vec2d cell_px{1.0};                            ///< size of a cell in film pixels, along a row and down
  Vec2d px_per_k{0.0};
  /// For slanted panels, whose rays start at their pixels instead of their lenses: full cone angle, parallax, and -1 if the
  /// phase decreases to the right, else 1.
  double cone = 0.0, parallax = 1.0, sign = 1.0;

  struct Cell {
    Vec2i lens{0};  ///< column and row of the lens
    /// Position relative to the cell's corner, in film pixels; the pixels below a lens are 1 apart.
    Vec2d in_cell{0.0};
    double in_lens = 0.0;  ///< distance of `place` to the right of the lens's centre, in lens widths
  };
  /// Returns the cell of a ray. `row`: the film row of the ray's pixel.
  Cell cell_of(Vec2d place, Vec2d k, int row) const;
};

/// Returns the mapping; none for optics without lenses. `optics` must pass validate().
std::optional<LensCells> lens_cells(const Optics& optics);

}  // namespace lippmann
