// The rows of `lippmann-bench light`. A row is a scene with its optics, samples and frames.
//
// Built-in scenes and files have 8 views of 128 x 128 pixels, or 48 views of 64 x 64 pixels if the name of the row ends in
// -quilt. The scenes of hostile_scenes.hpp have their own optics.
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
  std::string name;                ///< name for requests and tables
  RenderParams params;             ///< parameters that select path tracing
  std::function<Scene()> build{};  ///< builds the scene; if empty, the parameters name the scene
  int first = 0, count = 1;        ///< first frame and number of frames
  int reference_spp = 1024;        ///< samples per pixel of the two halves of the reference together
};

/// Returns the rows that the request names, or all rows if it names none. A name may be a row, a built-in scene or a file.
/// Throws a usage Error that lists the rows for any other name.
std::vector<LightCase> light_cases(const Request& request, const Context& context);

/// Returns the names of the rows of the benchmark `light` and their descriptions for printing, one row per line.
std::string light_row_list();

}  // namespace lippmann::bench
