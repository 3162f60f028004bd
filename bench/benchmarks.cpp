#include "bench/benchmarks.hpp"

namespace lippmann::bench {

const std::vector<Benchmark>& benchmarks() {
  static const std::vector<Benchmark> all{
      {"png", "CPU time and size of a PNG by strategy, filter and level", measure_png},
      {"rays", "rays per second of our passes beside bare Embree, by ray order and scene", measure_rays},
  };
  return all;
}

}  // namespace lippmann::bench
