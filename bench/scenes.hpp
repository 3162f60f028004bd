// The scenes of benchmarks. Every built-in scene is shown behind the default lens array, at a moment when all objects have
// moved.
#pragma once

#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "job/params.hpp"

namespace lippmann::bench {

/// Returns the parameters that benchmarks start from. As in the paper, scenes keep their full depth, even if it exceeds what a
/// display can resolve.
RenderParams params_of(const std::string& scene);

struct BenchScene {
  std::string name;
  RenderParams params;  ///< lenticular, 512 x 512, 64 lenses of 8 pixels, 28 degrees, full depth
  int frame = 0;
};

/// Returns the requested scenes, built-in ones or files; all built-in ones by default. Throws Error.
std::vector<BenchScene> bench_scenes(const Request& request, const Context& context);

/// The frames of an animation for measuring reuse, which start at a key frame of every interval up to 8.
struct BenchAnimation {
  std::string name;      ///< animations of Tachyon's scenes are named "tachyon teapot" and so on
  RenderParams params;   ///< as in BenchScene
  int first = 0, count;  ///< frames; `first` is a multiple of 8
};

/// Returns the requested animations. They may be of all built-in scenes and, if Tachyon's files are found, of its three scenes
/// with camera paths; with --large also of the large teapot, 384 lenses of 10 pixels. Throws Error.
std::vector<BenchAnimation> bench_animations(const Request& request, const Context& context);

/// Returns those of Tachyon's scenes teapot, room and smallballs (.dat) that are requested and that the folder contains.
std::vector<BenchScene> tachyon_scenes(const Request& request);

}  // namespace lippmann::bench
