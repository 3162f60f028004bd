#include "trace/path_film.hpp"

namespace lippmann {

void FirstSurfaces::add(const ShadingPoint& point, Vec3f normal_there, std::size_t pixel, float weight) const {
  for (int c = 0; c < 3; ++c) {
    albedo[3 * pixel + static_cast<std::size_t>(c)] += weight * point.base_color[c];
    normal[3 * pixel + static_cast<std::size_t>(c)] += weight * normal_there[c];
  }
  z[pixel] += weight * glm::dot(display_z, Vec4f(point.position, 1.0f));
  met[pixel] += weight;
}

Vec4f display_z(const Affine3f& world_from_display) {
  const Affine3f to_display = inverse(world_from_display);
  return {to_display.linear[0].z, to_display.linear[1].z, to_display.linear[2].z, to_display.translation.z};
}

}  // namespace lippmann
