// Many path rays meet the scene together, and are shaded in packets of those that have hit the same.
//
// Rays that have left a surface go everywhere: sixteen of them in a row hit several things, and each has to be evaluated for
// all lanes of a packet, most of them idle. Sorted, a packet is of one mesh or of the sky.
#pragma once

#include <memory>
#include <vector>

#include "trace/path_ray.hpp"

namespace lippmann {

class PathWave {
 public:
  /// Meets all of `rays` with the scene; both must outlive the wave.
  PathWave(const ShadedScene& scene, const std::vector<PathRay>& rays);

  std::size_t packets() const { return packets_; }
  /// The p-th packet of what was hit, sorted.
  void load(std::size_t p);

  /// Valid until the next load().
  const RayHitPacket& packet() const { return packet_; }
  const LaneMask& active() const { return active_; }
  /// By lane; those of active lanes have the throughput that the media on their way have left.
  PathRay* rays() { return lanes_; }

 private:
  void sort();

  const ShadedScene& scene_;
  const std::vector<PathRay>& rays_;
  std::size_t packets_;
  std::unique_ptr<RayHitPacket[]> met_;     ///< in the order of rays_
  std::unique_ptr<std::uint32_t[]> order_;  ///< indices of rays_
  RayHitPacket packet_;
  LaneMask active_;
  PathRay lanes_[kLanes];
};

/// Meets `rays` with the scene and calls shade(packet, active, rays of the active lanes) for all of them.
template <class Shade>
void trace_wave(const ShadedScene& scene, const std::vector<PathRay>& rays, const Shade& shade) {
  PathWave wave(scene, rays);
  for (std::size_t p = 0; p < wave.packets(); ++p) {
    wave.load(p);
    shade(wave.packet(), wave.active(), wave.rays());
  }
}

}  // namespace lippmann
