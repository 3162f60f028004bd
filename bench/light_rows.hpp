// The rows of `lippmann-bench light`. A row is a scene with its optics, samples and frames.
//
// Built-in scenes and files have 8 views of 128 x 128 pixels, or 48 views of 64 x 64 pixels if the name of the row ends in
// -quilt.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "job/params.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann::bench {

struct LightCase {
  std::string name;
  RenderParams params;
  std::function<Scene()> build{};
  int first = 0, count = 1;
  int reference_spp = 1024;
};

/// Returns the rows that the request names (rows, built-in scenes or files), or all rows if it names none. For any
/// other name, throws a usage Error that lists the rows.
std::vector<LightCase> light_cases(const Request& request, const Context& context);

std::string light_row_list();

}  // namespace lippmann::bench
