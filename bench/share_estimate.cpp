#include "bench/share_estimate.hpp"

#include <cmath>

namespace lippmann::bench {

ShareEstimate estimate_share(const std::vector<Share>& groups) {
  ShareEstimate all;
  for (const Share& group : groups) all.hits += group.hits, all.trials += group.trials;
  const double trials = all.trials;
  all.share = all.hits / trials;
  if (groups.size() < 2) {
    all.standard_error = std::sqrt(all.share * (1.0 - all.share) / trials);
    return all;
  }
  double squares = 0.0;
  for (const Share& group : groups) {
    const double residual = group.hits - all.share * group.trials;
    squares += residual * residual;
  }
  const double n = static_cast<double>(groups.size());
  all.standard_error = std::sqrt(n / (n - 1.0) * squares) / trials;
  return all;
}

}  // namespace lippmann::bench
