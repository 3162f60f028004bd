#include "optics/crossing.hpp"

namespace lippmann {

RayFrame make_ray_frame(const Affine3f& world_from_display, float z_front_mm) {
  const Mat3f& linear = world_from_display.linear;
  const float inverse_scale = 1.0f / uniform_scale(world_from_display);
  RayFrame frame;
  frame.origin = transform_point(world_from_display, Vec3f(0.0f, 0.0f, z_front_mm));
  frame.right = linear[0], frame.up = linear[1], frame.forward = -linear[2];
  frame.unit_right = linear[0] * inverse_scale, frame.unit_up = linear[1] * inverse_scale;
  frame.unit_forward = -linear[2] * inverse_scale;
  return frame;
}

}  // namespace lippmann
