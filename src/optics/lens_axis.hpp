// Lenses in a row and the panel cells below them: which lens a panel point belongs to, how steeply its ray leaves, which lenses
// see a point. One axis of a lens array; a microlens array has two.
//
// The axis has its own mm coordinate, 0 at the panel's centre (x for columns of lenses, -y for rows so that they count
// downwards as pixels do, xi for slanted sheets), and the panel coordinate s in pixels along it: the pixel coordinate itself
// where the axis is one of the panel's, so that no rounding comes between a pixel's edge and a cell's.
//   lens k         l_k = lens0 + k pitch
//   its cell       centred at l_k + (l_k - eye) g / V, which is pitch (1 + g/V) wide: `cell_px` pixels from start_px + k
//   cell_px on its rays       a point o pixels from the cell's centre leaves with slope -o m / g - (l_k - eye) / V per mm of z
// V is the viewing distance, g the gap, m the pixel pitch.
#pragma once

#include <cmath>

#include "core/multiversion.hpp"

namespace lippmann {

/// Constants of one axis. T is double where single points are worked out, float in the loops over pixels.
template <class T>
struct LensAxis {
  T start_px, cell_px, cells_per_px;  ///< cell 0 begins at start_px
  T lens0_mm, pitch_mm;
  T slope_per_px;    ///< m / g, times the parallax
  T vergence;        ///< 1 / V, per mm; 0 for an infinite viewing distance
  T eye_mm;          ///< where on this axis the viewer is that the cells converge to
  int whole_pixels;  ///< pixels per lens where that is whole and pixel 0 begins a cell; else 0

  template <class U>
  LensAxis<U> as() const {
    return {U(start_px),     U(cell_px),  U(1 / cell_px), U(lens0_mm), U(pitch_mm),
            U(slope_per_px), U(vergence), U(eye_mm),      whole_pixels};
  }
};

struct LensAxisSpec {
  double pitch_mm, offset_mm, gap_mm, viewing_distance_mm, eye_mm, pixel_pitch_mm;
  double centre_px;  ///< panel coordinate of the panel's centre
  int size_px;       ///< the panel's extent along the axis; 0 where the axis is not one of the panel's
  double parallax = 1.0;
};

/// Cells that come out whole and aligned to within 1/100 pixel over the whole panel (float parameters are no better than that)
/// are made exactly so, cell 0 beginning at pixel 0: then all rays of one directional view are parallel to the last bit. Else
/// lens 0 is the one nearest to the centre.
LensAxis<double> make_lens_axis(const LensAxisSpec& spec);

/// What the lens above a panel point makes of it.
template <class T>
struct LensRay {
  T lens_mm;  ///< where the line crosses z = 0
  T slope;    ///< per mm of z, towards the viewer
};

template <class T>
LIPPMANN_INLINE LensRay<T> lens_ray(const LensAxis<T>& axis, T s_px) {
  const T t = s_px - axis.start_px;
  T k = std::floor(t * axis.cells_per_px);
  T in_cell = t - k * axis.cell_px;
  // The product above may round across a boundary of cells; t - k cell is exact for whole cells and decides.
  const bool before = in_cell < T(0), after = in_cell >= axis.cell_px;
  k = before ? k - T(1) : k, in_cell = before ? in_cell + axis.cell_px : in_cell;
  k = after ? k + T(1) : k, in_cell = after ? in_cell - axis.cell_px : in_cell;
  const T lens = axis.lens0_mm + k * axis.pitch_mm;
  return {lens, -((in_cell - T(0.5) * axis.cell_px) * axis.slope_per_px) - (lens - axis.eye_mm) * axis.vergence};
}

// ---- The inverse, in double -----------------------------------------------------------------------------------------

/// Lenses first ... last; none where last < first.
struct LensRange {
  int first, last;
};

inline int cell_of(const LensAxis<double>& axis, double s_px) {
  return static_cast<int>(std::floor((s_px - axis.start_px) / axis.cell_px));
}

/// The lens that covers a point of the lens plane: a whole number, of any size.
inline double lens_at(const LensAxis<double>& axis, double x_mm) {
  return std::floor((x_mm - axis.lens0_mm) / axis.pitch_mm + 0.5);
}

/// Where the image of a point at (x_mm, z_mm), z != 0, lies below lens `lens_mm`: pixels from the centre of the lens's cell.
inline double image_offset_px(const LensAxis<double>& axis, double lens_mm, double x_mm, double z_mm) {
  return -((x_mm - lens_mm) / z_mm + (lens_mm - axis.eye_mm) * axis.vergence) / axis.slope_per_px;
}

/// All lenses that may hold the image of the point within `reach_px` of their cell's centre (up to rounding: one more on each
/// side), among those with cells in the panel's range s_low ... s_high.
LensRange lenses_near(const LensAxis<double>& axis, double x_mm, double z_mm, double reach_px, double s_low, double s_high);

/// Whether a point is so near to the lens plane that it cannot be told from one in it: where its image moves through the whole
/// cell for a sideways step that floats do not resolve, 1e-5 of a lens.
inline bool in_lens_plane(const LensAxis<double>& axis, double z_mm) {
  return std::abs(z_mm) * axis.slope_per_px * axis.cell_px <= 2e-5 * axis.pitch_mm;
}

}  // namespace lippmann
