// CPU time, and figures made of it.
#pragma once

#include <functional>
#include <vector>

namespace lippmann::bench {

/// CPU seconds that this thread spends in `work`: what other processes take does not count.
double seconds(const std::function<void()>& work);

/// The CPU seconds of the second of two runs: caches and branch predictors have seen the work before.
double second_run(const std::function<void()>& work);

double median(std::vector<double> values);

/// To three decimals, for reports.
double rounded(double value);

}  // namespace lippmann::bench
