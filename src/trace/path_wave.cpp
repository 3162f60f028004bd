#include "trace/path_wave.hpp"

#include <array>

namespace lippmann {
namespace {

/// Rays are sorted by the lowest bits of the id of the object that they hit.
constexpr std::size_t kBuckets = 64;

/// Loads up to 16 rays into a packet. Lanes from `count` on are inactive and repeat the last ray. `of_cameras` marks camera
/// rays that have passed only surfaces made transparent by alpha.
void load_rays(const PathRay* rays, std::size_t count, RayHitPacket& packet, LaneMask& active, LaneMask& of_cameras) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    const PathRay& ray = rays[std::min(i, count - 1)];
    packet.ray.org_x[i] = ray.origin.x, packet.ray.org_y[i] = ray.origin.y, packet.ray.org_z[i] = ray.origin.z;
    packet.ray.dir_x[i] = ray.direction.x, packet.ray.dir_y[i] = ray.direction.y, packet.ray.dir_z[i] = ray.direction.z;
    packet.ray.tnear[i] = ray.t_near;
    packet.ray.tfar[i] = kInfinity;
    active.lane[i] = i < count ? -1 : 0;
    of_cameras.lane[i] = ray.has_met_nothing() ? -1 : 0;
  }
}

std::size_t bucket_of(const HitPacket& hit, std::size_t lane) {
  const unsigned placed = hit.instID[0][lane];
  return (placed != kNoId ? placed : hit.geomID[lane]) % kBuckets;
}

constexpr std::size_t kStride = sizeof(RayHitPacket) / sizeof(float);

template <class Word>
LIPPMANN_INLINE void gather(const Word* from, const std::int32_t* place, Word* to) {
  LIPPMANN_FOR_LANES(i) to[i] = from[place[i]];
}

/// Gathers a packet from an array of packets. For each field, lane i is the float at the distance place[i] from lane 0 of the
/// field in met[0].
LIPPMANN_MULTIVERSION void gather_packet(const RayHitPacket* met, const std::int32_t* place, RayHitPacket& to) {
  gather(met->ray.org_x, place, to.ray.org_x);
  gather(met->ray.org_y, place, to.ray.org_y);
  gather(met->ray.org_z, place, to.ray.org_z);
  gather(met->ray.dir_x, place, to.ray.dir_x);
  gather(met->ray.dir_y, place, to.ray.dir_y);
  gather(met->ray.dir_z, place, to.ray.dir_z);
  gather(met->ray.tnear, place, to.ray.tnear);
  gather(met->ray.tfar, place, to.ray.tfar);
  gather(met->hit.Ng_x, place, to.hit.Ng_x);
  gather(met->hit.Ng_y, place, to.hit.Ng_y);
  gather(met->hit.Ng_z, place, to.hit.Ng_z);
  gather(met->hit.u, place, to.hit.u);
  gather(met->hit.v, place, to.hit.v);
  gather(met->hit.primID, place, to.hit.primID);
  gather(met->hit.geomID, place, to.hit.geomID);
  gather(met->hit.instID[0], place, to.hit.instID[0]);
}

}  // namespace

PathWave::PathWave(const ShadedScene& scene, const std::vector<PathRay>& rays)
    : scene_(scene),
      rays_(rays),
      packets_(packets_of(rays.size())),
      met_(std::make_unique_for_overwrite<RayHitPacket[]>(packets_)),
      order_(std::make_unique_for_overwrite<std::uint32_t[]>(rays.size())) {
  LaneMask of_cameras;
  for (std::size_t p = 0; p < packets_; ++p) {
    load_rays(&rays[p * kLanes], std::min<std::size_t>(kLanes, rays.size() - p * kLanes), met_[p], active_, of_cameras);
    scene.trace(active_, met_[p], Coherence::kIncoherent, &of_cameras);
  }
  sort();
}

void PathWave::sort() {
  std::array<std::uint32_t, kBuckets> next{};
  for (std::size_t r = 0; r < rays_.size(); ++r) ++next[bucket_of(met_[r / kLanes].hit, r % kLanes)];
  std::uint32_t before = 0;
  for (std::uint32_t& n : next) {
    const std::uint32_t count = n;
    n = before;
    before += count;
  }
  for (std::size_t r = 0; r < rays_.size(); ++r)
    order_[next[bucket_of(met_[r / kLanes].hit, r % kLanes)]++] = static_cast<std::uint32_t>(r);
}

void PathWave::load(std::size_t p) {
  const std::size_t first = p * kLanes, count = std::min<std::size_t>(kLanes, rays_.size() - first);
  alignas(64) std::int32_t place[kLanes];
  for (std::size_t i = 0; i < kLanes; ++i) {
    const std::size_t r = order_[first + std::min(i, count - 1)];
    place[i] = static_cast<std::int32_t>(r / kLanes * kStride + r % kLanes);
    active_.lane[i] = i < count ? -1 : 0;
    if (i < count) lanes_[i] = rays_[r];
  }
  gather_packet(met_.get(), place, packet_);
  for (std::size_t i = 0; i < count; ++i)
    if (lanes_[i].medium != kNoMedium)
      lanes_[i].throughput *= scene_.path->media.transmittance(lanes_[i].medium, packet_.ray.tfar[i]);
}

}  // namespace lippmann
