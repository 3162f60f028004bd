#include "trace/scene_query.hpp"

namespace lippmann {
namespace {

LIPPMANN_MULTIVERSION void meet_light(const WhittedLight& light, unsigned id, const LaneMask& active, RayHitPacket& packet) {
  const WorldSphere ball{light.position.x, light.position.y, light.position.z, light.visible_radius};
  LIPPMANN_FOR_LANES(i) {
    const LaneRay ray{packet.ray.org_x[i], packet.ray.org_y[i], packet.ray.org_z[i], packet.ray.dir_x[i],
                      packet.ray.dir_y[i], packet.ray.dir_z[i], packet.ray.tnear[i], packet.ray.tfar[i]};
    const float t = distance(ball, ray);
    const bool hit = (active.lane[i] != 0) & (t < kInfinity);
    packet.ray.tfar[i] = hit ? t : packet.ray.tfar[i];
    packet.hit.geomID[i] = hit ? id : packet.hit.geomID[i];
    packet.hit.instID[0][i] = hit ? kNoId : packet.hit.instID[0][i];
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

void intersect_scene(const DeviceScene::Impl& scene, const LaneMask& active, RayHitPacket& packet, Coherence coherence) {
  intersect_planes(scene, active, packet);
  if (scene.has_fixed) intersect(scene.fixed.get(), scene.native_width, active, packet, coherence);
  if (scene.has_moving) intersect(scene.moving.get(), scene.native_width, active, packet, coherence);
  for (std::size_t l = 0; l < scene.lights.size(); ++l)
    if (scene.lights[l].visible_radius > 0.0f) meet_light(scene.lights[l], kLightId + static_cast<unsigned>(l), active, packet);
}

}  // namespace lippmann
