// Measures CPU time.
#pragma once

#include <functional>
#include <vector>

namespace lippmann::bench {

/// Returns the CPU seconds that this thread spends in `work`, unaffected by other processes.
double seconds(const std::function<void()>& work);

/// Returns the CPU seconds of the second of two runs, when caches and branch predictors are warm.
double second_run(const std::function<void()>& work);

double median(std::vector<double> values);

/// Rounds to three decimals, for reports.
double rounded(double value);

}  // namespace lippmann::bench
