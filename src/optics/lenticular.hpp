// Computes the rays of a lenticular sheet. Across the lenses, a ray passes through the centre of its lens. Vertically, it
// points towards the height of the eye.
//
// 1. The viewer moves sideways at the height y_e and the distance V (eye_height_mm and viewing_distance_mm in optics.hpp).
//    Therefore rows converge in y for any slant a: dy/dz = (y_e - y) / (V + g), with the gap g.
// 2. The lens determines the slope of xi = x cos a + y sin a. It follows that dx/dz = (slope of xi - dy/dz sin a) / cos a.
// 3. The cells converge to the viewer at x = 0, that is, at xi_e = y_e sin a.
#pragma once

#include <vector>

#include "lippmann/optics/optics.hpp"
#include "optics/crossing.hpp"
#include "optics/lens_axis.hpp"
#include "optics/model.hpp"

namespace lippmann {

/// Per-frame constants of a sheet's rays. T is double for single points and float in loops over pixels.
template <class T>
struct LenticularConstants {
  LensAxis<T> axis;
  T half_height_px;
  T pixel_pitch_mm, gap_mm;
  T cosine, sine, inverse_cosine;
  T eye_y_mm, row_vergence;  ///< row_vergence: 1 / (viewing distance + gap)
  T z_front_mm, row_scale,
      row_shift_mm;  ///< a ray from height y on the panel has height row_scale * y + row_shift_mm at z_front

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

class LenticularSight;

// The functions of optics/model.hpp follow.

constexpr std::string_view kind_of(const LenticularSheet&) { return "lenticular"; }
constexpr int sub_pixels_of(const LenticularSheet&) { return 1; }
void check_model(const Panel& panel, const LenticularSheet& sheet);
void write_model(const LenticularSheet& sheet, nlohmann::ordered_json& json);
void read_model(const JsonFields& json, LenticularSheet& sheet);
OpticsFacts facts_of(const Panel& panel, const LenticularSheet& sheet);
inline float front_mm(const Panel& panel, const LenticularSheet& sheet, float chosen_mm) {
  return front_of_lenses_mm(panel, sheet.viewing_distance_mm, chosen_mm);
}
inline LenticularRays make_rays(const Panel& panel, const LenticularSheet& sheet, float z_front_mm) {
  return make_lenticular(panel, sheet, z_front_mm).as<float>();
}
inline Vec2f footprint_mm(const Panel& panel, const LenticularSheet& sheet, float z_mm) {
  const float m = panel.pixel_pitch_mm;
  return {lens_footprint_mm(sheet.lens_pitch_mm, sheet.gap_mm / sheet.parallax, sheet.viewing_distance_mm, m, z_mm),
          m * std::abs(1.0f - (z_mm + sheet.gap_mm) / (sheet.viewing_distance_mm + sheet.gap_mm))};
}
Vec2d zone_slope(const Panel& panel, const LenticularSheet& sheet, Vec2d share);
StepRule step_rule(const Panel& panel, const LenticularSheet& sheet, StepsWithin within);
void pixels_seeing(const Panel& panel, const LenticularSheet& sheet, Vec3f point_mm, std::vector<Vec2f>& pixels);
LenticularSight sight_of(const Panel& panel, const LenticularSheet& sheet);
std::optional<ViewCameras> cameras_of(const Panel& panel, const LenticularSheet& sheet);
LensCells lens_cells_of(const Panel& panel, const LenticularSheet& sheet);
void set_lenses(LenticularSheet& sheet, float pitch_mm, float gap_mm, Vec2f offset_mm);
const OpticsKindInfo& kind_info(const LenticularSheet&);

}  // namespace lippmann
