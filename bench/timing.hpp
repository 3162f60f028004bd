#pragma once

#include <functional>
#include <vector>

namespace lippmann::bench {

double seconds(const std::function<void()>& work);

/// Returns the CPU seconds of the second run, when caches and branch predictors are warm.
double second_run(const std::function<void()>& work);

double median(std::vector<double> values);

double rounded(double value);

}  // namespace lippmann::bench
