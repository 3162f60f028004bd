#include "trace/scene_query.hpp"

namespace lippmann {
namespace {

LIPPMANN_INLINE void record_hit(RayHitPacket& packet, const LaneMask& active, int i, float t, unsigned id) {
  const bool hit = (active.lane[i] != 0) & (t < kInfinity);
  packet.ray.tfar[i] = hit ? t : packet.ray.tfar[i];
  packet.hit.geomID[i] = hit ? id : packet.hit.geomID[i];
  packet.hit.instID[0][i] = hit ? kNoId : packet.hit.instID[0][i];
}

/// Meets the infinite planes: shortens tfar and records hits with the plane's id, kPlaneId + its index.
LIPPMANN_MULTIVERSION void meet_planes(const WorldPlaneRecord* planes, std::size_t count, const LaneMask& active,
                                       RayHitPacket& packet) {
  for (std::size_t p = 0; p < count; ++p) {
    const WorldPlane plane = planes[p].plane;
    const unsigned id = kPlaneId + static_cast<unsigned>(p);
    LIPPMANN_FOR_LANES(i) record_hit(packet, active, i, distance(plane, lane_ray(packet.ray, i)), id);
  }
}

/// Whether any ray's line comes as close to a visible light as its radius: a small part of the work of meeting it, and most
/// packets see no light.
LIPPMANN_INLINE int points_at(const WorldSphere ball, const RayPacket& rays) {
  int any = 0;
  LIPPMANN_FOR_LANES(i) any |= discriminant(ball, lane_ray(rays, i)) >= 0.0f ? -1 : 0;
  return any;
}

LIPPMANN_MULTIVERSION void meet_lights(const WhittedLight* lights, std::size_t count, const LaneMask& active,
                                       RayHitPacket& packet) {
  for (std::size_t l = 0; l < count; ++l) {
    const WorldSphere ball{lights[l].position.x, lights[l].position.y, lights[l].position.z, lights[l].visible_radius};
    if (!(ball.radius > 0.0f) || !points_at(ball, packet.ray)) continue;
    const unsigned id = kLightId + static_cast<unsigned>(l);
    LIPPMANN_FOR_LANES(i) record_hit(packet, active, i, distance(ball, lane_ray(packet.ray, i)), id);
  }
}

}  // namespace

LIPPMANN_MULTIVERSION void clear_hits(RayHitPacket& packet) {
  LIPPMANN_FOR_LANES(i) {
    packet.ray.time[i] = 0.0f;
    packet.ray.mask[i] = ~0u;
    packet.ray.id[i] = static_cast<unsigned>(i);
    packet.ray.flags[i] = 0;
    packet.hit.geomID[i] = kNoId;
    packet.hit.instID[0][i] = kNoId;
  }
}

void find_nearest(const DeviceScene::Impl& scene, const LaneMask& active, RayHitPacket& packet, Coherence coherence) {
  clear_hits(packet);
  if (!scene.planes.empty()) meet_planes(scene.planes.data(), scene.planes.size(), active, packet);
  const LaneMask sound = sound_lanes(packet.ray, scene.reach, active);
  if (scene.has_fixed) intersect(scene.fixed.get(), scene.native_width, sound, packet, coherence);
  if (scene.has_moving) intersect(scene.moving.get(), scene.native_width, sound, packet, coherence);
  if (scene.any_visible_light) meet_lights(scene.lights.data(), scene.lights.size(), active, packet);
}

}  // namespace lippmann
