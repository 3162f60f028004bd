#include "optics/microlens.hpp"

#include <numbers>

namespace lippmann {

MicrolensConstants<double> make_microlens(const Panel& panel, const MicrolensArray& array, double z_front_mm) {
  const bool hexagonal = array.packing == LensPacking::kHexagonal;
  const double pitch = array.lens_pitch_mm, row_pitch = hexagonal ? pitch * (0.5 * std::numbers::sqrt3) : pitch;
  LensAxisSpec columns{.pitch_mm = pitch,
                       .offset_mm = array.offset_mm.x,
                       .gap_mm = array.gap_mm,
                       .viewing_distance_mm = array.viewing_distance_mm,
                       .eye_mm = 0.0,
                       .pixel_pitch_mm = panel.pixel_pitch_mm,
                       .size_px = hexagonal ? 0 : panel.width};
  LensAxisSpec rows = columns;
  rows.pitch_mm = row_pitch, rows.offset_mm = -array.offset_mm.y;
  rows.size_px = hexagonal ? 0 : panel.height;
  // make_lens_axis renames the row nearest to the centre to row 0: where that was an odd row, its shift goes into the offset.
  const double renamed_rows = std::round(rows.offset_mm / row_pitch);
  if (hexagonal && std::fmod(renamed_rows, 2.0) != 0.0) columns.offset_mm += 0.5 * pitch;
  return {make_lens_axis(columns), make_lens_axis(rows), 0.5 * panel.width, 0.5 * panel.height, z_front_mm};
}

LIPPMANN_MULTIVERSION
void write_rays(const SquareMicrolensRays& constants, const RayFrame& frame, const float* px, const float* py, int count,
                const RayArrays& rays) {
  const SquareMicrolensRays c = constants;
  const RayFrame f = frame;
  const RayArrays r = rays;
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) write_ray(f, crossing(c, px[i], py[i]), r, i);
}

LIPPMANN_MULTIVERSION
void write_rays(const HexagonalMicrolensRays& constants, const RayFrame& frame, const float* px, const float* py, int count,
                const RayArrays& rays) {
  const HexagonalMicrolensRays c = constants;
  const RayFrame f = frame;
  const RayArrays r = rays;
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) write_ray(f, crossing(c, px[i], py[i]), r, i);
}

namespace {

using Constants = MicrolensConstants<double>;

void append_inside(const Constants& c, double px, double py, std::vector<Vec2f>& pixels) {
  if (px >= 0.0 && px < 2 * c.half_width_px && py >= 0.0 && py < 2 * c.half_height_px) pixels.emplace_back(px, py);
}

/// All pixel centres within reach of (px, py), row by row, for which belongs(px, py).
template <class Belongs>
void append_centres(const Constants& c, double px, double py, Vec2f reach_px, const Belongs& belongs,
                    std::vector<Vec2f>& pixels) {
  const auto bound = [](double p, double size) { return static_cast<int>(std::clamp(p, 0.0, size)); };
  const double width = 2 * c.half_width_px, height = 2 * c.half_height_px;
  for (int j = bound(py - reach_px.y - 1, height); j < bound(py + reach_px.y + 1, height); ++j)
    for (int i = bound(px - reach_px.x - 1, width); i < bound(px + reach_px.x + 1, width); ++i)
      if (belongs(i + 0.5, j + 0.5)) pixels.emplace_back(i + 0.5, j + 0.5);
}

// ---- Square packing ---------------------------------------------------------------------------------------------------

void append_square_cell(const Constants& c, double x, double down, std::vector<Vec2f>& pixels) {
  const int column = lens_at(c.columns, x), row = lens_at(c.rows, down);
  const double px = c.columns.start_px + (column + 0.5) * c.columns.cell_px + c.half_width_px;
  const double py = c.rows.start_px + (row + 0.5) * c.rows.cell_px + c.half_height_px;
  const auto belongs = [&](double qx, double qy) {
    return cell_of(c.columns, qx - c.half_width_px) == column && cell_of(c.rows, qy - c.half_height_px) == row;
  };
  append_centres(c, px, py, {0.5 * c.columns.cell_px, 0.5 * c.rows.cell_px}, belongs, pixels);
}

void append_square(const Constants& c, double x, double down, double z, std::vector<Vec2f>& pixels) {
  const double half_x = 0.5 * c.columns.cell_px, half_y = 0.5 * c.rows.cell_px;
  const LensRange columns = lenses_near(c.columns, x, z, half_x, -c.half_width_px, c.half_width_px);
  const LensRange rows = lenses_near(c.rows, down, z, half_y, -c.half_height_px, c.half_height_px);
  for (int r = rows.first; r <= rows.last; ++r) {
    const double dy = image_offset_px(c.rows, c.rows.lens0_mm + r * c.rows.pitch_mm, down, z);
    if (!(dy >= -half_y && dy < half_y)) continue;
    for (int k = columns.first; k <= columns.last; ++k) {
      const double dx = image_offset_px(c.columns, c.columns.lens0_mm + k * c.columns.pitch_mm, x, z);
      if (!(dx >= -half_x && dx < half_x)) continue;
      append_inside(c, c.columns.start_px + (k + 0.5) * c.columns.cell_px + dx + c.half_width_px,
                    c.rows.start_px + (r + 0.5) * c.rows.cell_px + dy + c.half_height_px, pixels);
    }
  }
}

// ---- Hexagonal packing ------------------------------------------------------------------------------------------------

void append_hexagonal_cell(const Constants& c, double x, double down, std::vector<Vec2f>& pixels) {
  const HexagonalCell<double> lens =
      nearest_hexagon((x - c.columns.lens0_mm) / c.columns.pitch_mm, (down - c.rows.lens0_mm) / c.rows.pitch_mm);
  const double px = c.columns.start_px + (lens.column + 0.5) * c.columns.cell_px + c.half_width_px;
  const double py = c.rows.start_px + (lens.row + 0.5) * c.rows.cell_px + c.half_height_px;
  const auto belongs = [&](double qx, double qy) {
    const HexagonalCell<double> cell = hexagon_at(c, qx, qy);
    return cell.row == lens.row && cell.column == lens.column;
  };
  append_centres(c, px, py, {0.5 * c.columns.cell_px, c.rows.cell_px}, belongs, pixels);
}

/// A hexagon reaches half a column step to either side and 2/3 of a row step up and down.
void append_hexagonal(const Constants& c, double x, double down, double z, std::vector<Vec2f>& pixels) {
  const double margin_x = c.columns.cell_px, margin_y = c.rows.cell_px;
  const LensRange columns =
      lenses_near(c.columns, x, z, 0.5 * c.columns.cell_px, -c.half_width_px - margin_x, c.half_width_px + margin_x);
  const LensRange rows =
      lenses_near(c.rows, down, z, c.rows.cell_px * (2.0 / 3.0), -c.half_height_px - margin_y, c.half_height_px + margin_y);
  for (int r = rows.first; r <= rows.last; ++r) {
    const double dy = image_offset_px(c.rows, c.rows.lens0_mm + r * c.rows.pitch_mm, down, z);
    for (int k = columns.first; k <= columns.last; ++k) {
      const double column = k + (r % 2 == 0 ? 0.0 : 0.5);
      const double dx = image_offset_px(c.columns, c.columns.lens0_mm + column * c.columns.pitch_mm, x, z);
      const double px = c.columns.start_px + (column + 0.5) * c.columns.cell_px + dx + c.half_width_px;
      const double py = c.rows.start_px + (r + 0.5) * c.rows.cell_px + dy + c.half_height_px;
      const HexagonalCell<double> cell = hexagon_at(c, px, py);
      if (cell.row == r && cell.column == column) append_inside(c, px, py, pixels);
    }
  }
}

}  // namespace

void pixels_seeing(const Panel& panel, const MicrolensArray& array, Vec3f point_mm, std::vector<Vec2f>& pixels) {
  const Constants c = make_microlens(panel, array, 0.0);
  const double x = point_mm.x, down = -point_mm.y, z = point_mm.z;
  const bool hexagonal = array.packing == LensPacking::kHexagonal;
  if (in_lens_plane(c.columns, z))
    hexagonal ? append_hexagonal_cell(c, x, down, pixels) : append_square_cell(c, x, down, pixels);
  else
    hexagonal ? append_hexagonal(c, x, down, z, pixels) : append_square(c, x, down, z, pixels);
}

}  // namespace lippmann
