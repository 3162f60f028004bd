#include "trace/shadow_queue.hpp"

namespace lippmann {

/// Moves the ray's origin to the smooth surface, with the same target on the light. Returns the new distance to the light.
float ShadowQueue::lift(const ShadingPoint& point, float distance, ShadowRay& ray) {
  const Vec3f up = point.lift();
  ray.origin += up;
  if (distance == kInfinity) return distance;
  const Vec3f way = distance * ray.direction - up;
  const float from_there = glm::length(way);
  if (from_there > 0.0f) ray.direction = way / from_there;
  return from_there;
}

std::size_t ShadowQueue::trace_packet(const ShadedScene& scene, std::size_t first) {
  const std::size_t count = std::min<std::size_t>(kLanes, rays_.size() - first);
  for (std::size_t i = 0; i < kLanes; ++i) {
    const ShadowRay& ray = rays_[first + std::min(i, count - 1)];
    packet_.rays.org_x[i] = ray.origin.x, packet_.rays.org_y[i] = ray.origin.y, packet_.rays.org_z[i] = ray.origin.z;
    packet_.rays.dir_x[i] = ray.direction.x, packet_.rays.dir_y[i] = ray.direction.y, packet_.rays.dir_z[i] = ray.direction.z;
    packet_.rays.tnear[i] = ray.t_near, packet_.rays.tfar[i] = ray.t_far;
    packet_.active.lane[i] = i < count ? -1 : 0;
    packet_.transmittance.white[i] = 1.0f;
  }
  scene.trace_shadows(packet_.active, packet_.rays, packet_.transmittance);
  return count;
}

}  // namespace lippmann
