// The scenes that benchmarks run on: every built-in one behind the default lens array, at a moment when everything has moved.
#pragma once

#include <string>
#include <vector>

#include "core/context.hpp"
#include "optics/optics.hpp"
#include "scene/scene.hpp"

namespace lippmann::bench {

struct BenchScene {
  std::string name;
  Scene scene;
  double time = 0.0;  ///< seconds
  Optics optics;      ///< lenticular, 512 x 512, 64 lenses of 8 pixels, 28 degrees
  Affine3f world_from_display;
};

std::vector<BenchScene> bench_scenes(const Context& context);

}  // namespace lippmann::bench
