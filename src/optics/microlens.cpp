#include "optics/microlens.hpp"

#include <numbers>

namespace lippmann {

using Vec2d = glm::dvec2;

MicrolensConstants<double> make_microlens(const Panel& panel, const MicrolensArray& array, double z_front_mm) {
  const bool hexagonal = array.packing == LensPacking::kHexagonal;
  const double pitch = array.lens_pitch_mm, row_pitch = hexagonal ? pitch * (0.5 * std::numbers::sqrt3) : pitch;
  LensAxisSpec columns{.pitch_mm = pitch,
                       .offset_mm = array.offset_mm.x,
                       .gap_mm = array.gap_mm,
                       .viewing_distance_mm = array.viewing_distance_mm,
                       .eye_mm = 0.0,
                       .pixel_pitch_mm = panel.pixel_pitch_mm,
                       .centre_px = 0.5 * panel.width,
                       .size_px = hexagonal ? 0 : panel.width,
                       .parallax = array.parallax};
  LensAxisSpec rows = columns;
  rows.pitch_mm = row_pitch, rows.offset_mm = -array.offset_mm.y;
  rows.centre_px = 0.5 * panel.height;
  rows.size_px = hexagonal ? 0 : panel.height;
  // make_lens_axis renames the row nearest to the centre to row 0: where that was an odd row, its shift goes into the offset.
  const double renamed_rows = std::round(rows.offset_mm / row_pitch);
  if (hexagonal && std::fmod(renamed_rows, 2.0) != 0.0) columns.offset_mm += 0.5 * pitch;
  return {make_lens_axis(columns), make_lens_axis(rows), z_front_mm};
}

LIPPMANN_MULTIVERSION
void write_block(const SquareMicrolensRays& c, const RayFrame& frame, const float* px, const float* py, const RayArrays& rays) {
  write_ray_block(frame, px, py, rays, [&c](float x, float y) LIPPMANN_INLINE_LAMBDA { return crossing(c, x, y); });
}

LIPPMANN_MULTIVERSION
void write_block(const HexagonalMicrolensRays& c, const RayFrame& frame, const float* px, const float* py,
                 const RayArrays& rays) {
  write_ray_block(frame, px, py, rays, [&c](float x, float y) LIPPMANN_INLINE_LAMBDA { return crossing(c, x, y); });
}

namespace {

/// Collects the pixels that see one point.
struct Search {
  MicrolensConstants<double> c;
  double width, height;
  std::vector<Vec2f>& pixels;

  /// The point `dx`, `dy` pixels from the centre of the cell at a (hexagonal: perhaps half) column and a row.
  Vec2d panel_point(double column, double row, double dx = 0.0, double dy = 0.0) const {
    return {c.columns.start_px + (column + 0.5) * c.columns.cell_px + dx, c.rows.start_px + (row + 0.5) * c.rows.cell_px + dy};
  }
  double offset_x(double column, double x, double z) const {
    return image_offset_px(c.columns, c.columns.lens0_mm + column * c.columns.pitch_mm, x, z);
  }
  double offset_y(double row, double down, double z) const {
    return image_offset_px(c.rows, c.rows.lens0_mm + row * c.rows.pitch_mm, down, z);
  }

  void append_inside(Vec2d p) const {
    if (p.x >= 0.0 && p.x < width && p.y >= 0.0 && p.y < height) pixels.emplace_back(p);
  }

  /// All pixel centres within `reach` of p, row by row, for which belongs(x, y).
  template <class Belongs>
  void append_centres(Vec2d p, Vec2d reach, const Belongs& belongs) const {
    const auto bound = [](double at, double size) { return static_cast<int>(std::clamp(at, 0.0, size)); };
    for (int j = bound(p.y - reach.y - 1, height); j < bound(p.y + reach.y + 1, height); ++j)
      for (int i = bound(p.x - reach.x - 1, width); i < bound(p.x + reach.x + 1, width); ++i)
        if (belongs(i + 0.5, j + 0.5)) pixels.emplace_back(i + 0.5, j + 0.5);
  }
};

// ---- Square packing ---------------------------------------------------------------------------------------------------

void append_square_cell(const Search& s, double x, double down) {
  const double column = lens_at(s.c.columns, x), row = lens_at(s.c.rows, down);
  const auto belongs = [&](double px, double py) { return cell_of(s.c.columns, px) == column && cell_of(s.c.rows, py) == row; };
  s.append_centres(s.panel_point(column, row), {0.5 * s.c.columns.cell_px, 0.5 * s.c.rows.cell_px}, belongs);
}

void append_square(const Search& s, double x, double down, double z) {
  const double half_x = 0.5 * s.c.columns.cell_px, half_y = 0.5 * s.c.rows.cell_px;
  const LensRange columns = lenses_near(s.c.columns, x, z, half_x, 0.0, s.width);
  const LensRange rows = lenses_near(s.c.rows, down, z, half_y, 0.0, s.height);
  for (int r = rows.first; r <= rows.last; ++r) {
    const double dy = s.offset_y(r, down, z);
    if (!(dy >= -half_y && dy < half_y)) continue;
    for (int k = columns.first; k <= columns.last; ++k) {
      const double dx = s.offset_x(k, x, z);
      if (dx >= -half_x && dx < half_x) s.append_inside(s.panel_point(k, r, dx, dy));
    }
  }
}

// ---- Hexagonal packing ------------------------------------------------------------------------------------------------

void append_hexagonal_cell(const Search& s, double x, double down) {
  const HexagonalCell<double> lens =
      nearest_hexagon((x - s.c.columns.lens0_mm) / s.c.columns.pitch_mm, (down - s.c.rows.lens0_mm) / s.c.rows.pitch_mm);
  const auto belongs = [&](double px, double py) {
    const HexagonalCell<double> cell = hexagon_at(s.c, px, py);
    return cell.row == lens.row && cell.column == lens.column;
  };
  s.append_centres(s.panel_point(lens.column, lens.row), {0.5 * s.c.columns.cell_px, s.c.rows.cell_px}, belongs);
}

/// A hexagon reaches half a column step to either side and 2/3 of a row step up and down.
void append_hexagonal(const Search& s, double x, double down, double z) {
  const double step_x = s.c.columns.cell_px, step_y = s.c.rows.cell_px;
  const LensRange columns = lenses_near(s.c.columns, x, z, 0.5 * step_x, -step_x, s.width + step_x);
  const LensRange rows = lenses_near(s.c.rows, down, z, step_y * (2.0 / 3.0), -step_y, s.height + step_y);
  for (int r = rows.first; r <= rows.last; ++r) {
    const double dy = s.offset_y(r, down, z);
    for (int k = columns.first; k <= columns.last; ++k) {
      const double column = k + (r % 2 == 0 ? 0.0 : 0.5);
      const Vec2d p = s.panel_point(column, r, s.offset_x(column, x, z), dy);
      const HexagonalCell<double> cell = hexagon_at(s.c, p.x, p.y);
      if (cell.row == r && cell.column == column) s.append_inside(p);
    }
  }
}

}  // namespace

void pixels_seeing(const Panel& panel, const MicrolensArray& array, Vec3f point_mm, std::vector<Vec2f>& pixels) {
  const Search search{make_microlens(panel, array, 0.0), 1.0 * panel.width, 1.0 * panel.height, pixels};
  const double x = point_mm.x, down = -point_mm.y, z = point_mm.z;
  const bool hexagonal = array.packing == LensPacking::kHexagonal;
  if (in_lens_plane(search.c.columns, z))
    hexagonal ? append_hexagonal_cell(search, x, down) : append_square_cell(search, x, down);
  else
    hexagonal ? append_hexagonal(search, x, down, z) : append_square(search, x, down, z);
}

}  // namespace lippmann
