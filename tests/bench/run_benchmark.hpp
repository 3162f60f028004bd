// Runs benchmarks within the test process. Each returns the report that `lippmann-bench NAME` prints as JSON.
#pragma once

#include <algorithm>
#include <string_view>

#include "bench/bench.hpp"

namespace lippmann::test {

/// Runs the benchmark `name`, which must exist, and returns its report.
inline bench::Report run_benchmark(std::string_view name, const bench::Request& request) {
  const auto& all = bench::benchmarks();
  const auto found = std::find_if(all.begin(), all.end(), [&](const bench::Benchmark& b) { return b.name == name; });
  return found->run(request, Context{});
}

/// Returns a request for small frames of the scenes. `frames` limits their number; 0 keeps the benchmark's default.
inline bench::Request quick_request(std::vector<std::string> scenes, int frames = 0) {
  bench::Request request;
  request.quick = true, request.frames = frames, request.scenes = std::move(scenes);
  return request;
}

}  // namespace lippmann::test
