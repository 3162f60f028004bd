// Benchmarks run in this process: what `lippmann-bench NAME` prints as JSON.
#pragma once

#include <algorithm>
#include <string_view>

#include "bench/bench.hpp"

namespace lippmann::test {

/// The benchmark must be one that there is.
inline bench::Report run_benchmark(std::string_view name, const bench::Request& request) {
  const auto& all = bench::benchmarks();
  const auto found = std::find_if(all.begin(), all.end(), [&](const bench::Benchmark& b) { return b.name == name; });
  return found->run(request, Context{});
}

/// A request for a few small frames of these scenes.
inline bench::Request quick_request(std::vector<std::string> scenes, int frames = 0) {
  bench::Request request;
  request.quick = true, request.frames = frames, request.scenes = std::move(scenes);
  return request;
}

}  // namespace lippmann::test
