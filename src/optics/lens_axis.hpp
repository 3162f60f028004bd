// One axis of a lens array: lenses in a row and the panel cells below them. A lenticular sheet has one axis. A microlens array
// has two axes.
//
// An axis has a coordinate in mm, which is 0 at the panel's centre: x for columns of lenses, -y for rows (rows count
// downwards), and for slanted sheets xi, the direction across the lenses. An axis also has a panel coordinate s in pixels. For
// columns and rows, s is the pixel coordinate.
//
// With the viewing distance V, the gap g, the pixel pitch m, and `eye` the viewer's coordinate on the axis:
//   Lens k is at l_k = lens0 + k pitch.
//   Its cell is centred at l_k + (l_k - eye) g / V. The cell is pitch (1 + g/V) wide and begins at pixel start_px + k cell_px.
//   The ray of a point o pixels from the centre of the cell has the slope -o m / g - (l_k - eye) / V, in mm per mm of z.
#pragma once

#include <cmath>

#include "core/multiversion.hpp"

namespace lippmann {

/// Constants of one axis. T is double for single points and float in loops over pixels.
template <class T>
struct LensAxis {
  T start_px, cell_px, cells_per_px;
  T lens0_mm, pitch_mm;
  T slope_per_px;  ///< m / g times the parallax factor, with pixel pitch m and gap g
  T vergence;      ///< 1 / viewing distance, per mm; 0 for an infinite distance
  T eye_mm;
  /// Number of pixels per lens if it is whole and a cell begins at pixel 0; otherwise 0.
  int whole_pixels;

  template <class U>
  LensAxis<U> as() const {
    return {U(start_px),     U(cell_px),  U(1 / cell_px), U(lens0_mm), U(pitch_mm),
            U(slope_per_px), U(vergence), U(eye_mm),      whole_pixels};
  }
};

struct LensAxisSpec {
  double pitch_mm, offset_mm, gap_mm, viewing_distance_mm, eye_mm, pixel_pitch_mm;
  double centre_px;
  int size_px;  ///< size of the panel along the axis; 0: cells are not aligned with pixels
  double parallax = 1.0;
};

/// Rounds the width and the edges of cells to whole pixels if they differ by at most 1/100 pixel. Cell 0 then begins at pixel
/// 0. Otherwise lens 0 is the lens nearest to the centre.
LensAxis<double> make_lens_axis(const LensAxisSpec& spec);

/// The line from a panel point through the centre of its lens.
template <class T>
struct LensRay {
  T lens_mm;
  T slope;
};

template <class T>
LIPPMANN_INLINE LensRay<T> lens_ray(const LensAxis<T>& axis, T s_px) {
  const T t = s_px - axis.start_px;
  T k = std::floor(t * axis.cells_per_px);
  T in_cell = t - k * axis.cell_px;
  // Rounding may have moved the index k of the cell across a cell boundary.
  const bool before = in_cell < T(0), after = in_cell >= axis.cell_px;
  k = before ? k - T(1) : k, in_cell = before ? in_cell + axis.cell_px : in_cell;
  k = after ? k + T(1) : k, in_cell = after ? in_cell - axis.cell_px : in_cell;
  const T lens = axis.lens0_mm + k * axis.pitch_mm;
  return {lens, -((in_cell - T(0.5) * axis.cell_px) * axis.slope_per_px) - (lens - axis.eye_mm) * axis.vergence};
}

struct LensRange {
  int first, last;
};

inline int cell_of(const LensAxis<double>& axis, double s_px) {
  return static_cast<int>(std::floor((s_px - axis.start_px) / axis.cell_px));
}

/// Returns the index of the lens that covers a point of the lens plane. It is a whole number, which may exceed the range of
/// int.
inline double lens_at(const LensAxis<double>& axis, double x_mm) {
  return std::floor((x_mm - axis.lens0_mm) / axis.pitch_mm + 0.5);
}

/// Returns the image of the point (x_mm, z_mm), z != 0, behind the lens at `lens_mm`, in pixels from the centre of the lens's
/// cell.
inline double image_offset_px(const LensAxis<double>& axis, double lens_mm, double x_mm, double z_mm) {
  return -((x_mm - lens_mm) / z_mm + (lens_mm - axis.eye_mm) * axis.vergence) / axis.slope_per_px;
}

/// Returns the lenses whose image of the point may lie within `reach_px` of the centre of their cell. Adds one lens at each end
/// for rounding. Excludes cells outside the panel, which extends from s_low to s_high pixels.
LensRange lenses_near(const LensAxis<double>& axis, double x_mm, double z_mm, double reach_px, double s_low, double s_high);

/// Returns whether a point at z counts as lying in the lens plane. The test is whether moving the point by 2e-5 lens pitches
/// moves its image across the whole cell, because floats do not resolve such small movements.
inline bool in_lens_plane(const LensAxis<double>& axis, double z_mm) {
  return std::abs(z_mm) * axis.slope_per_px * axis.cell_px <= 2e-5 * axis.pitch_mm;
}

}  // namespace lippmann
