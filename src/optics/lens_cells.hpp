// Maps the ray of a film pixel to its lens and to the position of the pixel below the lens.
//
// A ray is the line x(z) = l + s z, in mm. `place` is l, the point where the ray crosses the plane z = 0. k = l / V + s, with
// the viewing distance V. All pixels at the same position below their lenses have the same k (optics/view_place.hpp).
#pragma once

#include <optional>

#include "lippmann/core/math.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct LensCells {
  enum class Rows { kOfFilm, kSquare, kHexagonal };

  Rows rows = Rows::kOfFilm;  ///< kOfFilm: for cylindrical lenses, where each row of the film counts as a row of lenses
  Vec2d lenses_per_mm{0.0};
  double first_lens = 0.0;
  double rows_per_mm = 0.0, first_row_mm = 0.0;  ///< rows of lenses per mm, counted downwards; y of row 0
  Vec2d cell_px{1.0};                            ///< size of a cell in film pixels, along a row and down
  Vec2d px_per_k{0.0};
  /// For slanted panels: full angle of the view cone, parallax factor, and sign (-1 if SlantedPanel::inverted, otherwise 1).
  /// For other optics, cone is 0.
  double cone = 0.0, parallax = 1.0, sign = 1.0;

  struct Cell {
    Vec2i lens{0};
    /// Position of the pixel relative to the corner of the cell, in film pixels.
    Vec2d in_cell{0.0};
    double in_lens = 0.0;
  };
  Cell cell_of(Vec2d place, Vec2d k, int row) const;
};

std::optional<LensCells> lens_cells(const Optics& optics);

}  // namespace lippmann
