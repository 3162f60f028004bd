#include "lippmann/layout/lens_grid.hpp"

#include <cmath>
#include <utility>

#include "optics/lens_cells.hpp"

namespace lippmann {

LensGrid lens_grid(double pitch_px, double rotation, Vec2d offset_px, LensArrangement arrangement) {
  const bool is_square = arrangement == LensArrangement::kSquare;
  return {pitch_px, is_square ? pitch_px : pitch_px * 0.5 * std::numbers::sqrt3, rotation, offset_px, arrangement};
}

std::optional<LensGrid> lens_grid_of(const Optics& optics) {
  const std::optional<SensorLenses> lenses = sensor_lenses(optics);
  if (!lenses) return std::nullopt;
  const bool is_square = lenses->packing == LensPacking::kSquare;
  return LensGrid{lenses->pitch_px, lenses->row_pitch_px, 0.0, lenses->centre_px,
                  is_square ? LensArrangement::kSquare : LensArrangement::kHexagonal};
}

std::optional<LensGrid> elemental_images(const Optics& optics) {
  const std::optional<LensCells> cells = lens_cells(optics);
  if (!cells || cells->rows == LensCells::Rows::kOfFilm) return std::nullopt;
  const LensArray array = lens_array(optics).value();
  const double px_per_lens_mm = (1.0 + array.gap_mm / array.viewing_distance_mm) / optics.panel.pixel_pitch_mm;
  const Vec2d lens_mm(cells->first_lens / cells->lenses_per_mm.x, -cells->first_row_mm);  // right and down
  const Vec2d middle_px = 0.5 * Vec2d(optics.panel.width, optics.panel.height);
  const bool is_square = cells->rows == LensCells::Rows::kSquare;
  return LensGrid{cells->cell_px.x, cells->cell_px.y, 0.0, middle_px + lens_mm * px_per_lens_mm,
                  is_square ? LensArrangement::kSquare : LensArrangement::kHexagonal};
}

LensGrid transposed(const LensGrid& grid) {
  LensGrid swapped = grid;
  swapped.offset_px = {grid.offset_px.y, grid.offset_px.x};
  swapped.rotation = -grid.rotation;
  if (grid.arrangement == LensArrangement::kSquare) std::swap(swapped.pitch_px, swapped.row_pitch_px);
  if (grid.arrangement == LensArrangement::kHexagonal) swapped.arrangement = LensArrangement::kHexagonalColumns;
  if (grid.arrangement == LensArrangement::kHexagonalColumns) swapped.arrangement = LensArrangement::kHexagonal;
  return swapped;
}

Vec2d lens_centre(const LensGrid& grid, int column, int row) {
  const double shift = grid.arrangement == LensArrangement::kHexagonal && row % 2 != 0 ? 0.5 : 0.0;
  const double x = grid.pitch_px * (column + shift), y = grid.row_pitch_px * row;
  const double c = std::cos(grid.rotation), s = std::sin(grid.rotation);
  return grid.offset_px + Vec2d(c * x - s * y, s * x + c * y);
}

}  // namespace lippmann
