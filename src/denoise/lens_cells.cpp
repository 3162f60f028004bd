#include "denoise/lens_cells.hpp"

#include <cmath>

namespace lippmann {

std::optional<LensCells> LensCells::of(const Optics& optics) {
  LensCells cells;
  const Panel& panel = optics.panel;
  const double pixel_mm = panel.pixel_pitch_mm;
  if (const auto* slanted = std::get_if<SlantedPanel>(&optics.model)) {
    // The phase (x + y T) P - center of x and y from 0 to 1 across the panel and up it (slanted_panel.hpp).
    const double periods = slanted->periods;
    cells.kind_ = Kind::kSlantedPanel;
    cells.lenses_per_mm_ = Vec2d(1.0 / panel.width, slanted->tilt / panel.height) * (periods / pixel_mm);
    cells.first_lens_ = slanted->center - 0.5 * (1.0 + slanted->tilt) * periods;
    cells.cell_px_.x = film_size(optics).x / periods;
    cells.cone_ = slanted->view_cone, cells.parallax_ = slanted->parallax, cells.sign_ = slanted->inverted ? -1.0 : 1.0;
  } else if (const std::optional<LensArray> lenses = lens_array(optics)) {
    const double slope_per_px = pixel_mm / lenses->gap_mm;
    cells.cell_px_.x = lenses->cell_mm / pixel_mm;
    if (const auto* sheet = std::get_if<LenticularSheet>(&optics.model)) {
      const double slant = sheet->slant, pitch = sheet->lens_pitch_mm;
      cells.lenses_per_mm_ = Vec2d(std::cos(slant), std::sin(slant)) / pitch;
      cells.first_lens_ = sheet->offset_mm / pitch;
      cells.px_per_k_.x = 1.0 / (slope_per_px * sheet->parallax);
    } else if (const auto* array = std::get_if<MicrolensArray>(&optics.model)) {
      cells.kind_ = array->packing == LensPacking::kHexagonal ? Kind::kHexagonal : Kind::kSquare;
      cells.lenses_per_mm_.x = 1.0 / array->lens_pitch_mm, cells.first_lens_ = array->offset_mm.x / array->lens_pitch_mm;
      cells.rows_per_mm_ = 1.0 / lenses->row_pitch_mm, cells.first_row_mm_ = array->offset_mm.y;
      cells.cell_px_.y = cells.cell_px_.x * lenses->row_pitch_mm / lenses->pitch_mm;
      cells.px_per_k_ = Vec2d(1.0 / (slope_per_px * array->parallax));
    }
  } else {
    return std::nullopt;
  }
  if (!(cells.cell_px_.x >= 1.0 && cells.cell_px_.y >= 1.0)) return std::nullopt;
  return cells;
}

LensCells::Cell LensCells::cell_of(Vec2d place, Vec2d k, int row) const {
  Cell cell;
  double column = glm::dot(place, lenses_per_mm_) - first_lens_;
  if (kind_ == Kind::kSlantedPanel) {
    cell.in_lens = 0.5 + sign_ * std::atan(k.x / parallax_) / cone_;
    cell.in_cell.x = cell.in_lens * cell_px_.x;
    column -= cell.in_lens;
  } else {
    cell.in_cell = 0.5 * cell_px_ - k * px_per_k_;
  }
  cell.lens.y = row;
  if (rows_per_mm_ > 0.0) cell.lens.y = static_cast<int>(std::round((first_row_mm_ - place.y) * rows_per_mm_));
  if (kind_ == Kind::kHexagonal && cell.lens.y % 2 != 0) column -= 0.5;
  cell.lens.x = static_cast<int>(std::round(column));
  return cell;
}

}  // namespace lippmann
