// Sixteen paths side by side, as their rays have met something: what PathRay says of one. Private to src/trace.
#pragma once

#include "trace/path_ray.hpp"
#include "transport/sampler.hpp"

namespace lippmann {

/// Of the active lanes of a packet; where its rays begin and go is the packet's.
struct PathLanes {
  Lanes3 throughput;
  Lanes path_length, scattered_at, density;
  alignas(64) std::uint32_t pixel[kLanes];
  PathPairs numbers;  ///< seed and index of PathRay; first: the pair that this vertex begins with
  alignas(64) int depth[kLanes], events[kLanes];

  /// Primary rays: nothing has happened to them yet.
  LIPPMANN_INLINE void begin() {
    LIPPMANN_FOR_LANES(i) {
      throughput.x[i] = throughput.y[i] = throughput.z[i] = 1.0f;
      path_length[i] = scattered_at[i] = 0.0f;
      density[i] = kInfinity;
      numbers.first[i] = 0;
      depth[i] = events[i] = 0;
    }
  }

  void set(int i, const PathRay& ray) {
    throughput.set(i, ray.throughput);
    path_length[i] = ray.path_length, scattered_at[i] = ray.scattered_at, density[i] = ray.density;
    pixel[i] = ray.pixel;
    numbers.seed[i] = ray.seed, numbers.index[i] = ray.index, numbers.first[i] = kPairsPerEvent * ray.events;
    depth[i] = ray.depth, events[i] = ray.events;
  }

  /// Lane i, which came along the packet's ray.
  PathRay at(const RayPacket& rays, int i) const {
    PathRay ray;
    ray.origin = {rays.org_x[i], rays.org_y[i], rays.org_z[i]};
    ray.direction = {rays.dir_x[i], rays.dir_y[i], rays.dir_z[i]};
    ray.throughput = throughput.get(i);
    ray.path_length = path_length[i], ray.scattered_at = scattered_at[i], ray.density = density[i];
    ray.pixel = pixel[i];
    ray.seed = numbers.seed[i], ray.index = numbers.index[i];
    ray.depth = static_cast<std::uint16_t>(depth[i]);
    ray.events = static_cast<std::uint16_t>(events[i]) & 0x3fffu;
    return ray;
  }
};

}  // namespace lippmann
