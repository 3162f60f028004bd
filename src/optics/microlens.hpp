// Computes the rays of a microlens array. A ray runs straight from a pixel through the centre of the lenslet whose cell
// contains the pixel.
//
// Columns of lenses count to the right along x, rows downwards along -y. In hexagonal packing, rows are lens_pitch sqrt(3)/2
// apart, odd rows are shifted right by half a pitch, and a panel point belongs to the nearest cell centre.
#pragma once

#include <variant>
#include <vector>

#include "lippmann/optics/optics.hpp"
#include "optics/crossing.hpp"
#include "optics/lens_axis.hpp"
#include "optics/model.hpp"

namespace lippmann {

template <class T>
struct MicrolensConstants {
  /// The mm coordinate of `rows` is -y. In hexagonal packing, `columns` describes the cells of even rows.
  LensAxis<T> columns, rows;
  T z_front_mm;

  template <class U>
  MicrolensConstants<U> as() const {
    return {columns.template as<U>(), rows.template as<U>(), U(z_front_mm)};
  }
};

struct SquareMicrolensRays : MicrolensConstants<float> {};
struct HexagonalMicrolensRays : MicrolensConstants<float> {};

MicrolensConstants<double> make_microlens(const Panel& panel, const MicrolensArray& array, double z_front_mm);

LIPPMANN_INLINE Crossing crossing(const SquareMicrolensRays& c, float px, float py) {
  const LensRay<float> across = lens_ray(c.columns, px), down = lens_ray(c.rows, py);
  return {across.lens_mm + c.z_front_mm * across.slope, -(down.lens_mm + c.z_front_mm * down.slope), across.slope, -down.slope};
}

/// A position in a hexagonal lattice: the row and column of a lattice point, and the offset from it, in column steps and row
/// steps.
template <class T>
struct HexagonalCell {
  T row, column;
  T from_column, from_row;
};

/// Returns the nearest lattice point. u and v are column steps and row steps from the centre of lens (0, 0). The two adjacent
/// rows suffice, because every position is within 1/sqrt(3) column steps of a lens, and rows are sqrt(3)/2 column steps apart.
template <class T>
LIPPMANN_INLINE HexagonalCell<T> nearest_hexagon(T u, T v) {
  const T upper = std::floor(v), parity = upper - T(2) * std::floor(upper * T(0.5));
  const T shift_a = T(0.5) * parity, shift_b = T(0.5) - shift_a;
  const T column_a = std::floor(u - shift_a + T(0.5)) + shift_a, column_b = std::floor(u - shift_b + T(0.5)) + shift_b;
  const T du_a = u - column_a, dv_a = v - upper, du_b = u - column_b, dv_b = dv_a - T(1);
  const bool take_b = du_b * du_b + T(0.75) * (dv_b * dv_b) < du_a * du_a + T(0.75) * (dv_a * dv_a);
  return {take_b ? upper + T(1) : upper, take_b ? column_b : column_a, take_b ? du_b : du_a, take_b ? dv_b : dv_a};
}

/// Returns the lattice position of a pixel relative to the centre of the cell of lens (0, 0).
template <class T>
LIPPMANN_INLINE HexagonalCell<T> hexagon_at(const LensAxis<T>& columns, const LensAxis<T>& rows, T px, T py) {
  return nearest_hexagon((px - columns.start_px) * columns.cells_per_px - T(0.5),
                         (py - rows.start_px) * rows.cells_per_px - T(0.5));
}
template <class T>
LIPPMANN_INLINE HexagonalCell<T> hexagon_at(const MicrolensConstants<T>& c, T px, T py) {
  return hexagon_at(c.columns, c.rows, px, py);
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

class MicrolensSight;

// The functions of optics/model.hpp follow.

constexpr std::string_view kind_of(const MicrolensArray&) { return "microlens"; }
constexpr int sub_pixels_of(const MicrolensArray&) { return 1; }
void check_model(const Panel& panel, const MicrolensArray& array);
void write_model(const MicrolensArray& array, nlohmann::ordered_json& json);
void read_model(const JsonFields& json, MicrolensArray& array);
OpticsFacts facts_of(const Panel& panel, const MicrolensArray& array);
inline float front_mm(const Panel& panel, const MicrolensArray& array, float chosen_mm) {
  return front_of_lenses_mm(panel, array.viewing_distance_mm, chosen_mm);
}
std::variant<SquareMicrolensRays, HexagonalMicrolensRays> make_rays(const Panel& panel, const MicrolensArray& array,
                                                                    float z_front_mm);
inline Vec2f footprint_mm(const Panel& panel, const MicrolensArray& array, float z_mm) {
  const auto of_pitch = [&](float pitch) {
    return lens_footprint_mm(pitch, array.gap_mm / array.parallax, array.viewing_distance_mm, panel.pixel_pitch_mm, z_mm);
  };
  const float rows = array.packing == LensPacking::kHexagonal ? std::sqrt(0.75f) : 1.0f;
  return {of_pitch(array.lens_pitch_mm), of_pitch(array.lens_pitch_mm * rows)};
}
Vec2d zone_slope(const Panel& panel, const MicrolensArray& array, Vec2d share);
StepRule step_rule(const Panel& panel, const MicrolensArray& array, StepsWithin within);
void pixels_seeing(const Panel& panel, const MicrolensArray& array, Vec3f point_mm, std::vector<Vec2f>& pixels);
MicrolensSight sight_of(const Panel& panel, const MicrolensArray& array);
std::optional<ViewCameras> cameras_of(const Panel& panel, const MicrolensArray& array);
LensCells lens_cells_of(const Panel& panel, const MicrolensArray& array);
void set_lenses(MicrolensArray& array, float pitch_mm, float gap_mm, Vec2f offset_mm);
const OpticsKindInfo& kind_info(const MicrolensArray&);

}  // namespace lippmann
