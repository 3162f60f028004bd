// Rays of a lenticular sheet: across the lenses through the lens centre, along them towards the height of the eye.
//
// The viewer moves sideways at height y_e and distance V (optics.hpp: eye_height_mm, viewing_distance_mm), so that rows
// converge in y whatever the slant a: dy/dz = (y_e - y) / (V + g). The lens fixes the slope of xi = x cos a + y sin a, and
// dx/dz = (slope of xi - dy/dz sin a) / cos a. The cells converge to the viewer at x = 0, that is xi_e = y_e sin a.
#pragma once

#include <vector>

#include "lippmann/optics/optics.hpp"
#include "optics/crossing.hpp"
#include "optics/lens_axis.hpp"

namespace lippmann {

/// What a sheet's rays need per frame; double for single points, float for loops.
template <class T>
struct LenticularConstants {
  LensAxis<T> axis;  ///< along xi
  T half_height_px;
  T pixel_pitch_mm, gap_mm;
  T cosine, sine, inverse_cosine;         ///< of the slant
  T eye_y_mm, row_vergence;               ///< 1 / (V + g)
  T z_front_mm, row_scale, row_shift_mm;  ///< y at z_front = row_scale y + row_shift

  template <class U>
  LenticularConstants<U> as() const {
    return {axis.template as<U>(), U(half_height_px), U(pixel_pitch_mm), U(gap_mm),     U(cosine),    U(sine),
            U(inverse_cosine),     U(eye_y_mm),       U(row_vergence),   U(z_front_mm), U(row_scale), U(row_shift_mm)};
  }
};

using LenticularRays = LenticularConstants<float>;

LenticularConstants<double> make_lenticular(const Panel& panel, const LenticularSheet& sheet, double z_front_mm);

LIPPMANN_INLINE Crossing crossing(const LenticularRays& c, float px, float py) {
  const LensRay<float> across = lens_ray(c.axis, px * c.cosine - py * c.sine);
  const float y = (c.half_height_px - py) * c.pixel_pitch_mm;
  const float slope_y = (c.eye_y_mm - y) * c.row_vergence;
  const float xi_front = across.lens_mm + c.z_front_mm * across.slope;
  const float y_front = y * c.row_scale + c.row_shift_mm;
  return {(xi_front - y_front * c.sine) * c.inverse_cosine, y_front, (across.slope - slope_y * c.sine) * c.inverse_cosine,
          slope_y};
}

void write_block(const LenticularRays& constants, const RayFrame& frame, const float* px, const float* py,
                 const RayArrays& rays);

void pixels_seeing(const Panel& panel, const LenticularSheet& sheet, Vec3f point_mm, std::vector<Vec2f>& pixels);

}  // namespace lippmann
