#include "bench/timing.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lippmann::bench {
namespace {

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double seconds(const std::function<void()>& work) {
  const double start = cpu_seconds();
  work();
  return cpu_seconds() - start;
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
