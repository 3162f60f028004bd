// Estimates a share that is counted in groups, and its standard error.
#pragma once

#include <vector>

namespace lippmann::bench {

/// Hits among the trials of one group. Trials within a group may be correlated.
struct Share {
  int hits = 0, trials = 0;
};

struct ShareEstimate {
  int hits = 0, trials = 0;
  double share = 0.0;           ///< NaN without trials
  double standard_error = 0.0;  ///< assumes independent groups, or independent trials if there is only one group
};

/// Returns the number of all hits divided by that of all trials. The standard error is that of a ratio of sums over n groups
/// (Cochran, Sampling Techniques, 1977, eq. 6.13 without the correction for finite populations): sqrt(n / (n - 1) sum (hits_i -
/// share trials_i)^2) / sum trials_i.
ShareEstimate estimate_share(const std::vector<Share>& groups);

}  // namespace lippmann::bench
