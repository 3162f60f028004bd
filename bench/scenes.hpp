#pragma once

#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "job/params.hpp"

namespace lippmann::bench {

/// Scenes keep their full depth, as in the paper, even if it exceeds the depth that a display can resolve.
RenderParams params_of(const std::string& scene);

struct BenchScene {
  std::string name;
  /// a lenticular sheet of 512 x 512 pixels with 64 lenses of 8 pixels, a viewing zone of 28 degrees, and the scene's full
  /// depth
  RenderParams params;
  int frame = 0;
};

std::vector<BenchScene> bench_scenes(const Request& request, const Context& context);

/// `first` is a multiple of 8, so that it is a key frame if the distance between key frames is 2, 4 or 8.
struct BenchAnimation {
  std::string name;
  RenderParams params;  ///< the same optics as in BenchScene
  int first = 0, count;
};

/// Returns the requested animations: built-in scenes and, if Tachyon's files are found, its three scenes with camera paths.
/// --large adds the teapot with 384 lenses of 10 pixels. Throws Error for an unknown or missing animation.
std::vector<BenchAnimation> bench_animations(const Request& request, const Context& context);

std::vector<BenchScene> tachyon_scenes(const Request& request);

}  // namespace lippmann::bench
