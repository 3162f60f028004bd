// Sixteen paths side by side, as their rays have met something: what PathRay says of one, as far as kernels over lanes ask for
// it.
#pragma once

#include "trace/path_ray.hpp"
#include "transport/sampler.hpp"

namespace lippmann {

struct PathLanes {
  Lanes3 throughput;
  alignas(64) std::uint32_t pixel[kLanes];
  PathPairs numbers;  ///< seed and index of PathRay; first: the pair that this vertex begins with
  alignas(64) int depth[kLanes];

  void set(int i, const PathRay& ray) {
    throughput.set(i, ray.throughput);
    pixel[i] = ray.pixel, depth[i] = ray.depth;
    numbers.seed[i] = ray.seed, numbers.index[i] = ray.index, numbers.first[i] = kPairsPerEvent * ray.events;
  }
};

}  // namespace lippmann
