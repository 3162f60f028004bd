// Measures CPU time.
#pragma once

#include <functional>
#include <vector>

namespace lippmann::bench {

/// Returns the CPU seconds that this thread uses for `work`. Other processes do not affect it.
double seconds(const std::function<void()>& work);

/// Runs `work` twice, and returns the CPU seconds of the second run, when caches and branch predictors are warm.
double second_run(const std::function<void()>& work);

double median(std::vector<double> values);

/// Returns the value, rounded to three decimals.
double rounded(double value);

}  // namespace lippmann::bench
