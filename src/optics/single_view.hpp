#pragma once

#include <vector>

#include "lippmann/optics/optics.hpp"
#include "optics/crossing.hpp"
#include "optics/model.hpp"

namespace lippmann {

/// The rays of a pinhole at (0, eye_height, distance). They are computed relative to the pinhole, so that they start exactly
/// there if z_front = distance.
struct SingleViewRays {
  float centre_x_px, centre_y_px;  ///< centre of the panel minus SingleView::pixel_offset
  float pixel_pitch_mm;
  float eye_y_mm;
  float inverse_distance;
  float front_from_eye_mm;  ///< z of the plane z_front relative to the eye: z_front - distance, <= 0
};

SingleViewRays make_single_view(const Panel& panel, const SingleView& view, float z_front_mm);

LIPPMANN_INLINE Crossing crossing(const SingleViewRays& c, float px, float py) {
  const float slope_x = -((px - c.centre_x_px) * c.pixel_pitch_mm) * c.inverse_distance;
  const float slope_y = (c.eye_y_mm - (c.centre_y_px - py) * c.pixel_pitch_mm) * c.inverse_distance;
  return {c.front_from_eye_mm * slope_x, c.eye_y_mm + c.front_from_eye_mm * slope_y, slope_x, slope_y};
}

void write_block(const SingleViewRays& constants, const RayFrame& frame, const float* px, const float* py,
                 const RayArrays& rays);

class QuiltSight;

// The functions of optics/model.hpp follow.

constexpr std::string_view kind_of(const SingleView&) { return "single"; }
constexpr int sub_pixels_of(const SingleView&) { return 1; }
void check_model(const Panel& panel, const SingleView& view);
void write_model(const SingleView& view, nlohmann::ordered_json& json);
void read_model(const JsonFields& json, SingleView& view);
OpticsFacts facts_of(const Panel& panel, const SingleView& view);
inline float front_mm(const Panel&, const SingleView& view, float chosen_mm) { return std::min(chosen_mm, view.distance_mm); }
inline SingleViewRays make_rays(const Panel& panel, const SingleView& view, float z_front_mm) {
  return make_single_view(panel, view, z_front_mm);
}
inline Vec2f footprint_mm(const Panel& panel, const SingleView& view, float z_mm) {
  return Vec2f(panel.pixel_pitch_mm * std::abs(1.0f - z_mm / view.distance_mm));
}
inline Vec2d zone_slope(const Panel&, const SingleView&, Vec2d) { return Vec2d(0.0); }
inline StepRule step_rule(const Panel&, const SingleView&, StepsWithin) { return {}; }
void pixels_seeing(const Panel& panel, const SingleView& view, Vec3f point_mm, std::vector<Vec2f>& pixels);
QuiltSight sight_of(const Panel& panel, const SingleView& view);
std::optional<ViewCameras> cameras_of(const Panel& panel, const SingleView& view);
const OpticsKindInfo& kind_info(const SingleView&);

}  // namespace lippmann
