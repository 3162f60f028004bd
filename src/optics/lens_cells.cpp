#include "optics/lens_cells.hpp"

#include <cmath>

#include "optics/models.hpp"

namespace lippmann {

LensCells::Cell LensCells::cell_of(Vec2d place, Vec2d k, int row) const {
  Cell cell;
  double column = glm::dot(place, lenses_per_mm) - first_lens;
  if (cone > 0.0) {
    cell.in_lens = 0.5 + sign * std::atan(k.x / parallax) / cone;
    cell.in_cell.x = cell.in_lens * cell_px.x;
    column -= cell.in_lens;
  } else {
    cell.in_cell = 0.5 * cell_px - k * px_per_k;
  }
  cell.lens.y = rows == Rows::kOfFilm ? row : static_cast<int>(std::round((first_row_mm - place.y) * rows_per_mm));
  if (rows == Rows::kHexagonal && cell.lens.y % 2 != 0) column -= 0.5;
  cell.lens.x = static_cast<int>(std::round(column));
  return cell;
}

std::optional<LensCells> lens_cells(const Optics& optics) {
  return std::visit(
      [&]<class Model>(const Model& model) -> std::optional<LensCells> {
        if constexpr (HasLensCells<Model>)
          return lens_cells_of(optics.panel, model);
        else
          return std::nullopt;
      },
      optics.model);
}

}  // namespace lippmann
