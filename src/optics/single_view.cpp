#include "optics/single_view.hpp"

namespace lippmann {

SingleViewRays make_single_view(const Panel& panel, const SingleView& view, float z_front_mm) {
  return {0.5f * panel.width - view.pixel_offset.x, 0.5f * panel.height - view.pixel_offset.y, panel.pixel_pitch_mm,
          1.0f / view.distance_mm, z_front_mm - view.distance_mm};
}

LIPPMANN_MULTIVERSION
void write_block(const SingleViewRays& c, const RayFrame& frame, const float* px, const float* py, const RayArrays& rays) {
  write_ray_block(frame, px, py, rays, [&c](float x, float y) LIPPMANN_INLINE_LAMBDA { return crossing(c, x, y); });
}

void pixels_seeing(const Panel& panel, const SingleView& view, Vec3f point_mm, std::vector<Vec2f>& pixels) {
  const double distance = view.distance_mm, from_eye = distance - point_mm.z;
  if (!(from_eye > 0.0)) return;
  const double px_per_mm = distance / from_eye / panel.pixel_pitch_mm;
  const double px = 0.5 * panel.width - view.pixel_offset.x + point_mm.x * px_per_mm;
  const double py = 0.5 * panel.height - view.pixel_offset.y - point_mm.y * px_per_mm;
  if (px >= 0.0 && px < panel.width && py >= 0.0 && py < panel.height) pixels.emplace_back(px, py);
}

}  // namespace lippmann
