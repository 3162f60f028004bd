// The rows of `lippmann bench light`: scenes with optics, samples and frames.
//
// Built-in scenes and files are seen in 8 views of 128 x 128 pixels, or in 48 views of 64 x 64 where the row's name ends in
// -quilt. The hostile scenes (hostile_scenes.hpp) bring their own optics.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "job/params.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann::bench {

struct LightCase {
  std::string name;                ///< the row's
  RenderParams params;             ///< path tracing
  std::function<Scene()> build{};  ///< makes the scene; empty: the parameters name it
  int first = 0, count = 1;        ///< frames
  int reference_spp = 1024;        ///< of both halves of the reference together
};

/// The rows that the request names, else all. Throws a usage Error that lists the rows for a name that is neither a row, a
/// built-in scene nor a file.
std::vector<LightCase> light_cases(const Request& request, const Context& context);

/// One line per row, for people.
std::string light_row_list();

}  // namespace lippmann::bench
