// Projects a moved point back to a pixel. The point lands on the pixel that shows it, in the same directional view or below the
// same lens as before.
//
// Symbols, as in optics/lens_axis.hpp:
//   (X, Y, Z)  the moved point, mm in the display frame
//   l          position of a lens, mm
//   o          offset of a pixel from the centre of its lens's cell, pixels
//   m / g      slope of a ray per pixel of offset
//   V          viewing distance, mm
//   e          position of the eye to which the cells converge, mm
//
// Same view (`SplatMode::kView`):
//   The rays with the same offset o below every lens form an image of the scene with one sample per lens. The image is parallel
//   if V is infinite, and perspective otherwise.
//   The ray through lens position l has the slope -o m/g - (l - e)/V. The point is therefore seen through
//     l = (X + a Z) / (1 - Z/V),   a = o m/g - e/V
//   and belongs to the nearest lens.
//   Rows of a lenticular sheet and views of a quilt follow the same formula with o = 0. For rows, e is the height of the eye.
//   For views, e is the eye of the view.
//   If the number of pixels per lens is not whole, the point lands on the pixel of the lens that is nearest to the offset o. On
//   slanted sheets, this pixel is in the row where the point lands. In hexagonal arrays, it is within the cell.
//
// Same lens (`SplatMode::kLens`, as by Eljdid, Aggoun and Youssef, see README.md):
//   Lens l sees the point at the offset o = -((X - l)/Z + (l - e)/V) g/m in its cell. A point outside the cell is dropped.
//   A point very near the lens plane stays in its pixel, because a shift by 1/1000 of a lens would move its image through the
//   whole cell.
//   Single views and quilts have no lenses, and lenticular sheets have none along their axis. There, both modes are the same.
//
// The functions are inlined into the loops over the pixels of a row (splat.cpp), so that the compiler can vectorise these
// loops.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "lippmann/optics/optics.hpp"
#include "optics/crossing.hpp"
#include "optics/lenticular.hpp"
#include "optics/microlens.hpp"
#include "reuse/splat.hpp"

namespace lippmann {

/// Projected position of a point on one axis. `pixel` is an index, below 0 if the point is not visible. `off` is the offset
/// from the sample's centre, from -0.5 to 0.5 of the distance to the next sample of the same view.
struct AxisLanding {
  float pixel, off;
};

/// If the point is not visible, `column` or `row` is below 0.
struct PointLanding {
  float column, row, off_x, off_y;
};

inline constexpr float kNowhere = -1.0f;

/// Returns kNowhere if the point is not seen. Branches and bools in structs would prevent vectorisation.
LIPPMANN_INLINE float pixel_if(bool seen, float pixel) { return seen ? pixel : kNowhere; }

// ---- Regular grids: neighbouring samples of a view are a whole number of pixels apart -----------------------------------

/// Samples of a view along one axis. Position l (mm) belongs to sample k = floor(l * samples_per_mm + shift). Sample k is pixel
/// first + k * step, with GridLine::first.
struct GridScale {
  float samples_per_mm, shift, step;
};

struct GridLine {
  float place;  ///< position at which the pixel's rays cross z = 0, in mm
  float slope;  ///< a = o m/g - e/V, explained at the top of this file
  float first, low, high;
};

LIPPMANN_INLINE float position_on_line(float place, float slope, float vergence, float z) {
  return place - z * (slope + place * vergence);
}

LIPPMANN_INLINE AxisLanding land_on_grid(const GridScale& scale, const GridLine& line, float position, float z, float q) {
  const float l = (position + line.slope * z) * q;
  const float t = l * scale.samples_per_mm + scale.shift;
  const float k = std::floor(t);
  const float pixel = line.first + k * scale.step;
  return {pixel_if((pixel >= line.low) & (pixel <= line.high), pixel), t - k - 0.5f};
}

/// Landing rule for quilts, single views and arrays with a whole number of pixels per lens.
struct GridLanding {
  struct Constants {
    GridScale across, down;
    float vergence;  ///< 1 / viewing distance
  };
  struct Row {
    Constants c;
    const float *place, *slope, *first, *low, *high;
    GridLine line;  ///< position and slope along y, the same for all pixels of the row
  };

  Constants c;
  int width;
  /// Each vector has sets of `width` entries, one entry per column. Rows whose rays differ in direction use different sets.
  std::vector<float> place, slope, first, low, high;
  std::vector<GridLine> lines;
  std::vector<int> set_of_row;

  Row row(int j, int i) const {
    const auto r = static_cast<std::size_t>(j);
    const std::size_t at =
        static_cast<std::size_t>(set_of_row[r]) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i);
    return {c, place.data() + at, slope.data() + at, first.data() + at, low.data() + at, high.data() + at, lines[r]};
  }
};

LIPPMANN_INLINE Vec3f point_behind(const GridLanding::Row& r, int i, float z) {
  return {position_on_line(r.place[i], r.slope[i], r.c.vergence, z),
          -position_on_line(r.line.place, r.line.slope, r.c.vergence, z), z};
}

LIPPMANN_INLINE PointLanding land(const GridLanding::Row& r, int i, float x, float y, float z) {
  const float from_eye = 1.0f - z * r.c.vergence, q = 1.0f / from_eye;
  const AxisLanding across = land_on_grid(r.c.across, {0.0f, r.slope[i], r.first[i], r.low[i], r.high[i]}, x, z, q);
  const AxisLanding down = land_on_grid(r.c.down, r.line, -y, z, q);
  return {pixel_if(from_eye > 0.0f, across.pixel), down.pixel, across.off, down.off};
}

// ---- Lens arrays whose cells may have a fractional number of pixels -----------------------------------------------------

struct CellPlace {
  float lens;
  float offset;
};

LIPPMANN_INLINE CellPlace place_in_cell(const LensAxis<float>& axis, float s_px) {
  const float t = s_px - axis.start_px;
  float k = std::floor(t * axis.cells_per_px);
  float in_cell = t - k * axis.cell_px;
  const bool before = in_cell < 0.0f, after = in_cell >= axis.cell_px;
  k = before ? k - 1.0f : k, in_cell = before ? in_cell + axis.cell_px : in_cell;
  k = after ? k + 1.0f : k, in_cell = after ? in_cell - axis.cell_px : in_cell;
  return {k, in_cell - 0.5f * axis.cell_px};
}

inline constexpr float kNotSeen = std::numeric_limits<float>::quiet_NaN();

/// The lens through which a moved point is seen, and the offset of its image from the centre of the cell, in pixels. `offset`
/// is NaN if the point is not visible. `off` is the distance from the lens centre, in lenses.
struct CellLanding {
  float lens, offset, off;
};

LIPPMANN_INLINE CellLanding land_in_view(const LensAxis<float>& axis, CellPlace from, float x, float z) {
  const float from_eye = 1.0f - z * axis.vergence;
  const float l = (x + (from.offset * axis.slope_per_px - axis.eye_mm * axis.vergence) * z) / from_eye;
  const float t = (l - axis.lens0_mm) / axis.pitch_mm;
  const float lens = std::floor(t + 0.5f);
  return {lens, from_eye > 0.0f ? from.offset : kNotSeen, t - lens};
}

/// Returns the offset from the cell's centre (pixels) at which a lens shows a point. It may be outside the cell.
LIPPMANN_INLINE float offset_below_lens(const LensAxis<float>& axis, CellPlace from, float x, float z) {
  const float l = axis.lens0_mm + from.lens * axis.pitch_mm;
  const bool in_plane = std::abs(z) * axis.slope_per_px * axis.cell_px <= 1e-3f * axis.pitch_mm;
  const float offset = -((x - l) / z + (l - axis.eye_mm) * axis.vergence) / axis.slope_per_px;
  return in_plane ? from.offset : offset;
}

LIPPMANN_INLINE CellLanding land_below_lens(const LensAxis<float>& axis, CellPlace from, float x, float z) {
  const float half = 0.5f * axis.cell_px, offset = offset_below_lens(axis, from, x, z);
  const bool seen = (offset >= -half) & (offset < half) & (z * axis.vergence < 1.0f);
  return {from.lens, seen ? offset : kNotSeen, 0.0f};
}

template <SplatMode mode>
LIPPMANN_INLINE CellLanding land_in_cells(const LensAxis<float>& axis, CellPlace from, float x, float z) {
  return mode == SplatMode::kView ? land_in_view(axis, from, x, z) : land_below_lens(axis, from, x, z);
}

/// Returns the pixel at a position below a lens. At the edge of the cell, returns the nearest pixel whose centre is inside the
/// cell.
template <SplatMode mode>
LIPPMANN_INLINE AxisLanding pixel_below_lens(const LensAxis<float>& axis, const CellLanding& at, float begin, float per_pixel) {
  const float cell = axis.start_px + at.lens * axis.cell_px - begin;
  const float place = (cell + 0.5f * axis.cell_px + at.offset) * per_pixel;
  const float first = std::ceil(cell * per_pixel - 0.5f), end = std::ceil((cell + axis.cell_px) * per_pixel - 0.5f);
  float pixel = std::floor(place);  // a NaN offset gives a NaN pixel
  pixel = pixel < first ? first : pixel;
  pixel = pixel > end - 1.0f ? end - 1.0f : pixel;
  return {pixel_if((first < end) & (pixel >= 0.0f), pixel), mode == SplatMode::kView ? at.off : place - pixel - 0.5f};
}

// ---- Lenticular sheets, slanted or not ----------------------------------------------------------------------------------

template <SplatMode mode>
struct SheetLanding {
  struct Row {
    LenticularConstants<float> c;
    GridScale down;
    /// slope of the rays along y: height of the eye / viewing distance
    float eye_slope;
    float width, height;
    float px, py;  ///< panel coordinates of the centre of pixel 0, in pixels
  };

  Row constants;

  Row row(int j, int i) const {
    Row r = constants;
    r.px = static_cast<float>(i) + 0.5f, r.py = static_cast<float>(j) + 0.5f;
    return r;
  }
};

LIPPMANN_INLINE Vec3f point_on(const Crossing& line, float z) {
  return {line.x + z * line.slope_x, line.y + z * line.slope_y, z};
}

template <SplatMode mode>
LIPPMANN_INLINE PointLanding land_on_sheet(const typename SheetLanding<mode>::Row& s, int i, float x, float y, float z) {
  const CellPlace from = place_in_cell(s.c.axis, (s.px + static_cast<float>(i)) * s.c.cosine - s.py * s.c.sine);
  const float q = 1.0f / (1.0f - z * s.c.axis.vergence);
  const AxisLanding down = land_on_grid(s.down, {0.0f, s.eye_slope, 0.0f, 0.0f, s.height - 1.0f}, -y, z, q);
  const CellLanding lens = land_in_cells<mode>(s.c.axis, from, x * s.c.cosine + y * s.c.sine, z);
  const AxisLanding across = pixel_below_lens<mode>(s.c.axis, lens, -(down.pixel + 0.5f) * s.c.sine, s.c.inverse_cosine);
  return {pixel_if(across.pixel < s.width, across.pixel), down.pixel, across.off, down.off};
}

// ---- Microlenses --------------------------------------------------------------------------------------------------------

struct MicrolensRow {
  MicrolensConstants<float> c;
  float width, height;
  float px, py;  ///< panel coordinates of the centre of pixel 0, in pixels
};

template <SplatMode mode>
struct SquareLanding {
  using Row = MicrolensRow;
  Row constants;

  Row row(int j, int i) const {
    return {constants.c, constants.width, constants.height, static_cast<float>(i) + 0.5f, static_cast<float>(j) + 0.5f};
  }
};

template <SplatMode mode>
LIPPMANN_INLINE PointLanding land_on_squares(const MicrolensRow& s, int i, float x, float y, float z) {
  const CellPlace from = place_in_cell(s.c.columns, s.px + static_cast<float>(i)), from_row = place_in_cell(s.c.rows, s.py);
  const AxisLanding across = pixel_below_lens<mode>(s.c.columns, land_in_cells<mode>(s.c.columns, from, x, z), 0.0f, 1.0f);
  const AxisLanding down = pixel_below_lens<mode>(s.c.rows, land_in_cells<mode>(s.c.rows, from_row, -y, z), 0.0f, 1.0f);
  return {pixel_if(across.pixel < s.width, across.pixel), pixel_if(down.pixel < s.height, down.pixel), across.off, down.off};
}

template <SplatMode mode>
struct HexagonLanding {
  using Row = MicrolensRow;
  Row constants;

  Row row(int j, int i) const {
    return {constants.c, constants.width, constants.height, static_cast<float>(i) + 0.5f, static_cast<float>(j) + 0.5f};
  }
};

/// The lens that covers a position of the panel, and the offset from the centre of its cell in pixels.
struct HexagonPlace {
  float column, row;  ///< odd rows of lenses are shifted by half a column
  float offset_x, offset_y;
};

LIPPMANN_INLINE HexagonPlace place_in_hexagon(const MicrolensConstants<float>& c, float px, float py) {
  const HexagonalCell<float> cell = hexagon_at(c, px, py);
  return {cell.column, cell.row, cell.from_column * c.columns.cell_px, cell.from_row * c.rows.cell_px};
}

/// Returns the pixel at a position below a lens. If the centre of this pixel belongs to a neighbouring lens, returns the next
/// pixel towards the centre of the cell.
LIPPMANN_INLINE PointLanding pixel_below_hexagon(const MicrolensConstants<float>& c, float column, float row, float offset_x,
                                                 float offset_y) {
  const float centre_x = c.columns.start_px + (column + 0.5f) * c.columns.cell_px;
  const float centre_y = c.rows.start_px + (row + 0.5f) * c.rows.cell_px;
  const float distance = std::sqrt(offset_x * offset_x + offset_y * offset_y);
  const float inwards = distance > 1.0f ? (distance - 1.0f) / distance : 0.0f;
  const float i = std::floor(centre_x + offset_x), j = std::floor(centre_y + offset_y);
  const float near_i = std::floor(centre_x + offset_x * inwards), near_j = std::floor(centre_y + offset_y * inwards);
  const HexagonalCell<float> cell = hexagon_at(c, i + 0.5f, j + 0.5f), near_cell = hexagon_at(c, near_i + 0.5f, near_j + 0.5f);
  const bool own = (cell.column == column) & (cell.row == row);
  const bool near_own = (near_cell.column == column) & (near_cell.row == row);
  const float x = own ? i : near_i, y = own ? j : near_j;
  return {pixel_if(own | near_own, x), y, centre_x + offset_x - x - 0.5f, centre_y + offset_y - y - 0.5f};
}

template <SplatMode mode>
LIPPMANN_INLINE PointLanding land_on_hexagons(const MicrolensRow& s, int i, float x, float y, float z) {
  const HexagonPlace from = place_in_hexagon(s.c, s.px + static_cast<float>(i), s.py);
  const LensAxis<float>&columns = s.c.columns, &rows = s.c.rows;
  PointLanding at;
  if constexpr (mode == SplatMode::kView) {
    const float q = 1.0f / (1.0f - z * columns.vergence);
    const float u = ((x + from.offset_x * columns.slope_per_px * z) * q - columns.lens0_mm) / columns.pitch_mm;
    const float v = ((-y + from.offset_y * rows.slope_per_px * z) * q - rows.lens0_mm) / rows.pitch_mm;
    const HexagonalCell<float> lens = nearest_hexagon(u, v);
    at = pixel_below_hexagon(s.c, lens.column, lens.row, from.offset_x, from.offset_y);
    at.off_x = lens.from_column, at.off_y = lens.from_row;
  } else {
    const float dx = offset_below_lens(columns, {from.column, from.offset_x}, x, z);
    const float dy = offset_below_lens(rows, {from.row, from.offset_y}, -y, z);
    const HexagonalCell<float> cell = hexagon_at(s.c, columns.start_px + (from.column + 0.5f) * columns.cell_px + dx,
                                                 rows.start_px + (from.row + 0.5f) * rows.cell_px + dy);
    at = pixel_below_hexagon(s.c, from.column, from.row, dx, dy);
    at.column = pixel_if((cell.column == from.column) & (cell.row == from.row), at.column);
  }
  at.column = pixel_if((z * columns.vergence < 1.0f) & (at.column < s.width), at.column);
  at.row = pixel_if(at.row < s.height, at.row);
  return at;
}

// ---- Overloads for every landing rule -----------------------------------------------------------------------------------

// point_by() returns the point at depth z on the ray of pixel i of a row. land_by() returns where a point of pixel i lands
// after it has moved to (x, y, z).

LIPPMANN_INLINE Vec3f point_by(const GridLanding&, const GridLanding::Row& row, int i, float z) {
  return point_behind(row, i, z);
}
LIPPMANN_INLINE PointLanding land_by(const GridLanding&, const GridLanding::Row& row, int i, float x, float y, float z) {
  return land(row, i, x, y, z);
}
template <SplatMode mode>
LIPPMANN_INLINE Vec3f point_by(const SheetLanding<mode>&, const typename SheetLanding<mode>::Row& row, int i, float z) {
  return point_on(crossing(row.c, row.px + static_cast<float>(i), row.py), z);
}
template <SplatMode mode>
LIPPMANN_INLINE PointLanding land_by(const SheetLanding<mode>&, const typename SheetLanding<mode>::Row& row, int i, float x,
                                     float y, float z) {
  return land_on_sheet<mode>(row, i, x, y, z);
}
template <SplatMode mode>
LIPPMANN_INLINE Vec3f point_by(const SquareLanding<mode>&, const MicrolensRow& row, int i, float z) {
  return point_on(crossing(SquareMicrolensRays{row.c}, row.px + static_cast<float>(i), row.py), z);
}
template <SplatMode mode>
LIPPMANN_INLINE PointLanding land_by(const SquareLanding<mode>&, const MicrolensRow& row, int i, float x, float y, float z) {
  return land_on_squares<mode>(row, i, x, y, z);
}
template <SplatMode mode>
LIPPMANN_INLINE Vec3f point_by(const HexagonLanding<mode>&, const MicrolensRow& row, int i, float z) {
  return point_on(crossing(HexagonalMicrolensRays{row.c}, row.px + static_cast<float>(i), row.py), z);
}
template <SplatMode mode>
LIPPMANN_INLINE PointLanding land_by(const HexagonLanding<mode>&, const MicrolensRow& row, int i, float x, float y, float z) {
  return land_on_hexagons<mode>(row, i, x, y, z);
}

}  // namespace lippmann
