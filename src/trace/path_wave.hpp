// Traces path rays, and regroups them into packets of rays that hit the same object.
//
// Without regrouping, most lanes would be idle while a packet is shaded, because scattered rays diverge.
#pragma once

#include <memory>
#include <vector>

#include "trace/path_ray.hpp"

namespace lippmann {

class PathWave {
 public:
  PathWave(const ShadedScene& scene, const std::vector<PathRay>& rays);

  std::size_t packets() const { return packets_; }
  void load(std::size_t p);

  /// The results of packet(), active() and rays() are valid until the next load().
  const RayHitPacket& packet() const { return packet_; }
  const LaneMask& active() const { return active_; }
  /// Returns one ray per lane. The throughput of active lanes includes the transmittance of media along the ray.
  PathRay* rays() { return lanes_; }

 private:
  void sort();

  const ShadedScene& scene_;
  const std::vector<PathRay>& rays_;
  std::size_t packets_;
  std::unique_ptr<RayHitPacket[]> met_;  ///< traced packets in the order of rays_
  std::unique_ptr<std::uint32_t[]> order_;
  RayHitPacket packet_;
  LaneMask active_;
  PathRay lanes_[kLanes];
};

/// Traces `rays`, and calls shade(packet, active lanes, rays of the lanes) for each regrouped packet.
template <class Shade>
void trace_wave(const ShadedScene& scene, const std::vector<PathRay>& rays, const Shade& shade) {
  PathWave wave(scene, rays);
  for (std::size_t p = 0; p < wave.packets(); ++p) {
    wave.load(p);
    shade(wave.packet(), wave.active(), wave.rays());
  }
}

}  // namespace lippmann
