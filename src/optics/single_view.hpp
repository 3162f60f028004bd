// Rays of one pinhole in front of the display plane, through the rectangle of the panel in z = 0.
#pragma once

#include <vector>

#include "lippmann/optics/optics.hpp"
#include "optics/crossing.hpp"

namespace lippmann {

/// The pinhole at (0, 0, distance). Rays are told from the pinhole, so that they leave it exactly where z_front = distance.
struct SingleViewRays {
  float centre_x_px, centre_y_px;  ///< the panel's centre less the offset of the sample points
  float pixel_pitch_mm;
  float inverse_distance;   ///< per mm
  float front_from_eye_mm;  ///< z_front - distance, <= 0
};

SingleViewRays make_single_view(const Panel& panel, const SingleView& view, float z_front_mm);

LIPPMANN_INLINE Crossing crossing(const SingleViewRays& c, float px, float py) {
  const float slope_x = -((px - c.centre_x_px) * c.pixel_pitch_mm) * c.inverse_distance;
  const float slope_y = -((c.centre_y_px - py) * c.pixel_pitch_mm) * c.inverse_distance;
  return {c.front_from_eye_mm * slope_x, c.front_from_eye_mm * slope_y, slope_x, slope_y};
}

void write_block(const SingleViewRays& constants, const RayFrame& frame, const float* px, const float* py,
                 const RayArrays& rays);

void pixels_seeing(const Panel& panel, const SingleView& view, Vec3f point_mm, std::vector<Vec2f>& pixels);

}  // namespace lippmann
