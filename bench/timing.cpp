#include "bench/timing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/platform.hpp"

namespace lippmann::bench {
double seconds(const std::function<void()>& work) {
  const double start = platform::thread_cpu_seconds();
  work();
  return platform::thread_cpu_seconds() - start;
}

double second_run(const std::function<void()>& work) {
  work();
  return seconds(work);
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

double rounded(double value) { return std::round(value * 1000.0) / 1000.0; }

}  // namespace lippmann::bench
