#pragma once

#include <vector>

namespace lippmann::bench {

/// Hits and trials of one group. The trials of a group may be correlated.
struct Share {
  int hits = 0, trials = 0;
};

struct ShareEstimate {
  int hits = 0, trials = 0;
  double share = 0.0;
  /// assumes that groups are independent; with a single group, assumes that trials are independent
  double standard_error = 0.0;
};

/// Returns the ratio r of all hits to all trials. The standard error is that of a ratio of sums over n groups: sqrt(n / (n - 1)
/// sum (hits_i - r trials_i)^2) / sum trials_i (Cochran, Sampling Techniques, 1977, eq. 6.13 without the correction for finite
/// populations).
ShareEstimate estimate_share(const std::vector<Share>& groups);

}  // namespace lippmann::bench
