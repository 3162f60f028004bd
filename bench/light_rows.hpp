// The rows of `lippmann-bench light`: scenes with their optics, samples and frames.
//
// Built-in scenes and files have 8 views of 128 x 128 pixels, or 48 views of 64 x 64 if the row's name ends in -quilt. The
// hostile scenes (hostile_scenes.hpp) define their own optics.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "job/params.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann::bench {

/// One row of the benchmark.
struct LightCase {
  std::string name;                ///< name of the row
  RenderParams params;             ///< must select path tracing
  std::function<Scene()> build{};  ///< builds the scene; empty: the parameters name it
  int first = 0, count = 1;        ///< the first frame and the number of frames
  int reference_spp = 1024;        ///< samples per pixel of both halves of the reference together
};

/// Returns the rows that the request names, or all rows if it names none. Throws a usage Error that lists the rows if a name is
/// neither a row, a built-in scene nor a file.
std::vector<LightCase> light_cases(const Request& request, const Context& context);

/// Returns a readable list of the rows, one per line.
std::string light_row_list();

}  // namespace lippmann::bench
