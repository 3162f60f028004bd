// The scenes that benchmarks run on: every built-in one behind the default lens array, at a moment when everything has moved.
#pragma once

#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "job/params.hpp"

namespace lippmann::bench {

/// What every benchmark starts from: whatever a display could resolve, all of a scene's depth is rendered, as in the paper and
/// in all figures of before depth was fitted by default.
RenderParams params_of(const std::string& scene);

struct BenchScene {
  std::string name;
  RenderParams params;  ///< lenticular, 512 x 512, 64 lenses of 8 pixels, 28 degrees, full depth
  int frame = 0;
};

/// Those that the request names, built-in ones or files; all built-in ones where it names none. Throws Error.
std::vector<BenchScene> bench_scenes(const Request& request, const Context& context);

/// The frames that an animation with reuse is measured on: from a key frame of every interval up to 8.
struct BenchAnimation {
  std::string name;      ///< Tachyon's own are called "tachyon teapot" and so on
  RenderParams params;   ///< as in BenchScene
  int first = 0, count;  ///< frames; `first` is a multiple of 8
};

/// All built-in scenes, and Tachyon's own three with their camera paths where they are found: those that the request names; and
/// the large teapot, 384 lenses of 10 pixels, where it asks for that.
/// Throws Error.
std::vector<BenchAnimation> bench_animations(const Request& request, const Context& context);

/// Which of Tachyon's own teapot, room and smallballs (.dat) are in a folder; those of them that the request names.
std::vector<BenchScene> tachyon_scenes(const Request& request);

}  // namespace lippmann::bench
