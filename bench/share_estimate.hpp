// Estimates a share from hits and trials in groups, and the standard error of the share.
#pragma once

#include <vector>

namespace lippmann::bench {

/// Hits and trials of one group. The trials of a group may be correlated.
struct Share {
  int hits = 0, trials = 0;
};

struct ShareEstimate {
  int hits = 0, trials = 0;
  double share = 0.0;  ///< hits divided by trials; NaN without trials
  /// assumes that groups are independent; with a single group, assumes that trials are independent
  double standard_error = 0.0;
};

/// Returns the number of all hits divided by the number of all trials. The standard error is that of a ratio of sums over n
/// groups: sqrt(n / (n - 1) sum (hits_i - share trials_i)^2) / sum trials_i (Cochran, Sampling Techniques, 1977, eq. 6.13
/// without the correction for finite populations).
ShareEstimate estimate_share(const std::vector<Share>& groups);

}  // namespace lippmann::bench
