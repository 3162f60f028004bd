// The scenes of benchmarks. Every built-in scene is shown behind the default lens array, at a time when all objects have moved.
#pragma once

#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "job/params.hpp"

namespace lippmann::bench {

/// Returns the parameters that benchmarks start from. As in the paper, scenes keep their full depth, even if it exceeds the
/// depth that a display can resolve.
RenderParams params_of(const std::string& scene);

struct BenchScene {
  std::string name;
  /// a lenticular sheet of 512 x 512 pixels with 64 lenses of 8 pixels, a viewing zone of 28 degrees, and the scene's full
  /// depth
  RenderParams params;
  int frame = 0;
};

/// Returns the requested scenes, which are built in or files. Returns all built-in scenes if none is requested. Throws Error.
std::vector<BenchScene> bench_scenes(const Request& request, const Context& context);

/// The frames of an animation for measuring reuse. The first frame is a key frame for every interval of 2, 4 or 8 frames.
struct BenchAnimation {
  std::string name;      ///< animations of Tachyon's scenes have names such as "tachyon teapot"
  RenderParams params;   ///< the same optics as in BenchScene
  int first = 0, count;  ///< first frame, a multiple of 8, and number of frames
};

/// Returns the requested animations. All built-in scenes are possible. If Tachyon's files are found, its three scenes with
/// camera paths are possible too. With --large, the teapot with 384 lenses of 10 pixels is added. Throws Error.
std::vector<BenchAnimation> bench_animations(const Request& request, const Context& context);

/// Returns the requested scenes among Tachyon's teapot, room and smallballs (.dat), if the folder contains them.
std::vector<BenchScene> tachyon_scenes(const Request& request);

}  // namespace lippmann::bench
