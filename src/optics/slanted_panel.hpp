// Computes the rays of a calibrated slanted panel. Each sub-pixel has one ray, in the direction in which the lens above it
// emits its light.
//
// 1. (x, y) is the position of a sub-pixel, from 0 to 1 across and up the panel. Its phase below the lenses is (x + y T) P -
//    center, with T = SlantedPanel::tilt and P = SlantedPanel::periods.
// 2. Its position in the view cone is v = 1 - fract(phase), or fract(phase) if the panel is not inverted.
// 3. Its ray comes from the eye at (parallax distance tan(cone (v - 1/2)), eye_height, distance) and crosses the plane z = 0 at
//    the position of the sub-pixel.
// Phases are doubles because there may be thousands of lenses.
#pragma once

#include <cmath>
#include <vector>

#include "lippmann/optics/optics.hpp"
#include "optics/crossing.hpp"
#include "optics/model.hpp"
#include "optics/multi_view.hpp"

namespace lippmann {

struct SlantedPanelRays {
  double lenses_per_px, lenses_per_row;  ///< increase of the phase per panel pixel to the right, and per panel row up
  double phase_at_corner;
  float phase_sign;  ///< -1 if view v = 1 - fract(phase), 1 if v = fract(phase)
  float half_cone;
  float width_px, height_px;
  float pixel_mm;
  float eye_reach_mm;  ///< x of a view's eye is eye_reach_mm times the tangent of the view's angle
  float eye_y_mm;
  float distance_mm, inverse_distance;
  float front_from_eye_mm;  ///< z of the plane z_front relative to the eye: z_front - distance, <= 0
  /// Positions of sub-pixels relative to their pixel's centre, in panel pixels, y up. The index of a sub-pixel is 3 (2 (row mod
  /// 4) + column mod 2) + colour, where rows count from the bottom.
  float offset_x[24], offset_y[24];
};

SlantedPanelRays make_slanted_panel(const Panel& panel, const SlantedPanel& slanted, float z_front_mm);

LIPPMANN_INLINE Crossing crossing(const SlantedPanelRays& c, float px, float py) {
  const float sub_pixel = std::floor(px), column = std::floor((sub_pixel + 0.5f) * (1.0f / 3.0f)), row = std::floor(py);
  const float color = sub_pixel - 3.0f * column;
  const float up = c.height_px - 1.0f - row;
  const int cell = (static_cast<int>(up) & 3) * 2 + (static_cast<int>(column) & 1);
  const int at = cell * 3 + static_cast<int>(color);
  const float in_x = 0.5f + c.offset_x[at] + (px - sub_pixel - 0.5f) * (1.0f / 3.0f);
  const float in_y = 1.0f - (py - row) + c.offset_y[at];
  const double phase = (static_cast<double>(column) + static_cast<double>(in_x)) * c.lenses_per_px +
                       (static_cast<double>(up) + static_cast<double>(in_y)) * c.lenses_per_row + c.phase_at_corner;
  const float from_middle = c.phase_sign * (static_cast<float>(phase - std::floor(phase)) - 0.5f);
  const float eye_x = c.eye_reach_mm * tangent_of_double(c.half_cone * from_middle);
  const float x = (column - 0.5f * c.width_px + in_x) * c.pixel_mm, y = (up - 0.5f * c.height_px + in_y) * c.pixel_mm;
  const float slope_x = (eye_x - x) * c.inverse_distance, slope_y = (c.eye_y_mm - y) * c.inverse_distance;
  return {eye_x + c.front_from_eye_mm * slope_x, c.eye_y_mm + c.front_from_eye_mm * slope_y, slope_x, slope_y};
}

void write_block(const SlantedPanelRays& constants, const RayFrame& frame, const float* px, const float* py,
                 const RayArrays& rays);

class SlantedSight;

struct SlantedLens {
  float pitch_mm;
  float slope_step;
};

inline SlantedLens slanted_lens(const Panel& panel, const SlantedPanel& slanted) {
  const auto sub_pixels = static_cast<float>(3 * panel.width / slanted.periods);
  return {sub_pixels * (panel.pixel_pitch_mm / 3.0f), 2.0f * std::tan(0.5f * slanted.view_cone) / sub_pixels};
}

// The functions of optics/model.hpp follow.

constexpr std::string_view kind_of(const SlantedPanel&) { return "slanted"; }
constexpr int sub_pixels_of(const SlantedPanel&) { return 3; }
void check_model(const Panel& panel, const SlantedPanel& slanted);
void write_model(const SlantedPanel& slanted, nlohmann::ordered_json& json);
void read_model(const JsonFields& json, SlantedPanel& slanted);
OpticsFacts facts_of(const Panel& panel, const SlantedPanel& slanted);
inline float front_mm(const Panel&, const SlantedPanel& slanted, float chosen_mm) {
  return std::min(chosen_mm, slanted.distance_mm);
}
inline SlantedPanelRays make_rays(const Panel& panel, const SlantedPanel& slanted, float z_front_mm) {
  return make_slanted_panel(panel, slanted, z_front_mm);
}
inline Vec2f footprint_mm(const Panel& panel, const SlantedPanel& slanted, float z_mm) {
  const float pixel = panel.pixel_pitch_mm * std::abs(1.0f - z_mm / slanted.distance_mm);
  return {std::max(pixel, std::abs(z_mm) * slanted_lens(panel, slanted).slope_step * slanted.parallax), pixel};
}
Vec2d zone_slope(const Panel& panel, const SlantedPanel& slanted, Vec2d share);
StepRule step_rule(const Panel& panel, const SlantedPanel& slanted, StepsWithin within);
void pixels_seeing(const Panel& panel, const SlantedPanel& slanted, Vec3f point_mm, std::vector<Vec2f>& pixels);
SlantedSight sight_of(const Panel& panel, const SlantedPanel& slanted);
LensCells lens_cells_of(const Panel& panel, const SlantedPanel& slanted);
inline ViewPhases view_phases_of(const SlantedPanel& slanted) {
  return {slanted.periods, slanted.tilt, slanted.center, slanted.inverted, slanted.sub_pixels};
}

}  // namespace lippmann
