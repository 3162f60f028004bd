#include "trace/primary.hpp"

#include "trace/scene_query.hpp"

namespace lippmann {
namespace {

LIPPMANN_MULTIVERSION void store(const RayHitPacket& packet, float* t, float* u, float* v, std::uint32_t* geometry,
                                 std::uint32_t* primitive) {
  LIPPMANN_FOR_LANES(i) {
    const unsigned placed = packet.hit.instID[0][i];
    t[i] = packet.ray.tfar[i];
    u[i] = packet.hit.u[i], v[i] = packet.hit.v[i];
    geometry[i] = placed != kNoId ? placed : packet.hit.geomID[i];
    primitive[i] = packet.hit.primID[i];
  }
}

}  // namespace

void PrimaryHits::resize(std::size_t lanes) {
  t.resize(lanes), u.resize(lanes), v.resize(lanes);
  geometry.resize(lanes), primitive.resize(lanes);
}

std::uint64_t trace_primary_strip(const PacketSource& source, const DeviceScene::Impl& scene, int strip, int sample,
                                  PrimaryHits& hits) {
  hits.resize(static_cast<std::size_t>(source.packets_per_strip()) * kLanes);
  RayHitPacket packet;
  LaneMask active;
  alignas(64) std::uint32_t pixel[kLanes];
  std::uint64_t rays = 0;
  for (int p = 0; p < source.packets_per_strip(); ++p) {
    const auto at = static_cast<std::size_t>(p) * kLanes;
    const int count = source.fill(strip, p, sample, packet.ray, active, pixel);
    clear_hits(packet);
    if (count > 0) intersect_scene(scene, active, packet, Coherence::kCoherent);
    store(packet, &hits.t[at], &hits.u[at], &hits.v[at], &hits.geometry[at], &hits.primitive[at]);
    rays += static_cast<std::uint64_t>(count);
  }
  return rays;
}

}  // namespace lippmann
