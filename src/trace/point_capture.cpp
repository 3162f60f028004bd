#include "trace/point_capture.hpp"

#include "shading/surface.hpp"

namespace lippmann {
namespace {

/// Computes the z of each ray's end point in the display frame.
LIPPMANN_MULTIVERSION void depths(const RayPacket& rays, const Affine3f& display_from_world, Lanes& out) {
  const Vec3f row(display_from_world.linear[0].z, display_from_world.linear[1].z, display_from_world.linear[2].z);
  const float shift = display_from_world.translation.z;
  for (int i = 0; i < kLanes; ++i) {
    const float t = rays.tfar[i];
    const float x = rays.org_x[i] + t * rays.dir_x[i], y = rays.org_y[i] + t * rays.dir_y[i],
                z = rays.org_z[i] + t * rays.dir_z[i];
    out[i] = row.x * x + row.y * y + row.z * z + shift;
  }
}

}  // namespace

void PointCapture::store(const CameraPacket& camera) const {
  const RayHitPacket& packet = camera.rays;
  Lanes z;
  depths(packet.ray, display_from_world_, z);
  const auto lights_begin = static_cast<std::uint32_t>(scene_.scene->instances.size());
  for (int i = 0; i < kLanes; ++i) {
    if (!camera.active.lane[i]) continue;
    const std::size_t at = camera.target[i];
    const unsigned id = packet.hit.geomID[i];
    points_.z[at] = id == kNoId ? -kInfinity : z[i];
    if (id == kNoId)
      points_.object[at] = kNoObject;
    else
      points_.object[at] = id >= kLightId ? lights_begin + (id - kLightId) : hit_instance(scene_, packet, i);
  }
}

}  // namespace lippmann
