// Rays of a microlens array: straight through the centre of the lenslet whose cell holds the pixel, in both directions.
//
// Both axes count as pixels do: columns of lenses to the right along x, rows of lenses downwards along -y, so that a pixel's
// half-open square [i, i + 1) x [j, j + 1) and a cell agree on who owns an edge. Hexagonal packing: rows are
// lens_pitch sqrt(3)/2 apart, odd rows are shifted right by half a pitch; a panel point belongs to the nearest cell centre.
#pragma once

#include <vector>

#include "lippmann/optics/optics.hpp"
#include "optics/crossing.hpp"
#include "optics/lens_axis.hpp"

namespace lippmann {

template <class T>
struct MicrolensConstants {
  LensAxis<T> columns, rows;  ///< the rows' mm coordinate is -y; hexagonal: the cells of even rows
  T z_front_mm;

  template <class U>
  MicrolensConstants<U> as() const {
    return {columns.template as<U>(), rows.template as<U>(), U(z_front_mm)};
  }
};

/// The two packings are two types, so that each has its own loop.
struct SquareMicrolensRays : MicrolensConstants<float> {};
struct HexagonalMicrolensRays : MicrolensConstants<float> {};

MicrolensConstants<double> make_microlens(const Panel& panel, const MicrolensArray& array, double z_front_mm);

LIPPMANN_INLINE Crossing crossing(const SquareMicrolensRays& c, float px, float py) {
  const LensRay<float> across = lens_ray(c.columns, px), down = lens_ray(c.rows, py);
  return {across.lens_mm + c.z_front_mm * across.slope, -(down.lens_mm + c.z_front_mm * down.slope), across.slope, -down.slope};
}

/// A place in a hexagonal lattice: row r (odd ones shifted by half a step), column k, and how far from that centre, in column
/// steps and row steps.
template <class T>
struct HexagonalCell {
  T row, column;  ///< column counts half steps in odd rows: k + 1/2
  T from_column, from_row;
};

/// The nearest lattice point. u: columns steps from the centre of lens (0, 0), v: row steps. Only the two rows on either side
/// can hold it: no point is farther than 1/sqrt(3) steps from a lens, and rows are sqrt(3)/2 steps apart.
template <class T>
LIPPMANN_INLINE HexagonalCell<T> nearest_hexagon(T u, T v) {
  const T upper = std::floor(v), parity = upper - T(2) * std::floor(upper * T(0.5));
  const T shift_a = T(0.5) * parity, shift_b = T(0.5) - shift_a;
  const T column_a = std::floor(u - shift_a + T(0.5)) + shift_a, column_b = std::floor(u - shift_b + T(0.5)) + shift_b;
  const T du_a = u - column_a, dv_a = v - upper, du_b = u - column_b, dv_b = dv_a - T(1);
  const bool take_b = du_b * du_b + T(0.75) * (dv_b * dv_b) < du_a * du_a + T(0.75) * (dv_a * dv_a);
  return {take_b ? upper + T(1) : upper, take_b ? column_b : column_a, take_b ? du_b : du_a, take_b ? dv_b : dv_a};
}

/// Steps of the lattice from the centre of lens (0, 0)'s cell.
template <class T>
LIPPMANN_INLINE HexagonalCell<T> hexagon_at(const MicrolensConstants<T>& c, T px, T py) {
  return nearest_hexagon((px - c.columns.start_px) * c.columns.cells_per_px - T(0.5),
                         (py - c.rows.start_px) * c.rows.cells_per_px - T(0.5));
}

LIPPMANN_INLINE Crossing crossing(const HexagonalMicrolensRays& c, float px, float py) {
  const HexagonalCell<float> cell = hexagon_at<float>(c, px, py);
  const float lens_x = c.columns.lens0_mm + cell.column * c.columns.pitch_mm;
  const float lens_down = c.rows.lens0_mm + cell.row * c.rows.pitch_mm;
  const float slope_x = -(cell.from_column * (c.columns.cell_px * c.columns.slope_per_px)) - lens_x * c.columns.vergence;
  const float slope_down = -(cell.from_row * (c.rows.cell_px * c.rows.slope_per_px)) - lens_down * c.rows.vergence;
  return {lens_x + c.z_front_mm * slope_x, -(lens_down + c.z_front_mm * slope_down), slope_x, -slope_down};
}

void write_block(const SquareMicrolensRays& constants, const RayFrame& frame, const float* px, const float* py,
                 const RayArrays& rays);
void write_block(const HexagonalMicrolensRays& constants, const RayFrame& frame, const float* px, const float* py,
                 const RayArrays& rays);

void pixels_seeing(const Panel& panel, const MicrolensArray& array, Vec3f point_mm, std::vector<Vec2f>& pixels);

}  // namespace lippmann
