#include "trace/path_ray.hpp"

namespace lippmann {

PathRay primary_path_ray(const RayHitPacket& packet, int i, std::uint32_t pixel) {
  PathRay ray;
  ray.origin = {packet.ray.org_x[i], packet.ray.org_y[i], packet.ray.org_z[i]};
  ray.direction = {packet.ray.dir_x[i], packet.ray.dir_y[i], packet.ray.dir_z[i]};
  ray.pixel = pixel;
  return ray;
}

PathRay passed(PathRay ray, const ShadingPoint& point, float length) {
  ray.origin = point.position;
  ray.t_near = point.t_near;
  ray.path_length = length;
  ++ray.events;
  return ray;
}

PathRay scattered(PathRay ray, const ShadingPoint& point, const BsdfSample& sample, Vec3f throughput, float length) {
  ray.origin = point.position, ray.direction = sample.direction;
  ray.throughput = throughput;
  ray.t_near = point.t_near, ray.path_length = length;
  ++ray.depth, ++ray.events;
  // What shines straight behind is reached by the last vertex's shadow rays, too.
  if (!sample.straight) ray.density = sample.density, ray.scattered_at = length;
  return ray;
}

}  // namespace lippmann
