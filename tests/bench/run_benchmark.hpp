#pragma once

#include <algorithm>
#include <string_view>

#include "bench/bench.hpp"

namespace lippmann::test {

inline bench::Report run_benchmark(std::string_view name, const bench::Request& request) {
  const auto& all = bench::benchmarks();
  const auto found = std::find_if(all.begin(), all.end(), [&](const bench::Benchmark& b) { return b.name == name; });
  return found->run(request, Context{});
}

/// `frames` limits the number of frames; 0 keeps the benchmark's default.
inline bench::Request quick_request(std::vector<std::string> scenes, int frames = 0) {
  bench::Request request;
  request.quick = true, request.frames = frames, request.scenes = std::move(scenes);
  return request;
}

}  // namespace lippmann::test
