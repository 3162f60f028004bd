#include "bench/share_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lippmann::bench {
namespace {

TEST(ShareEstimate, one_group_has_the_binomial_error) {
  const ShareEstimate estimate = estimate_share({{9, 10}});
  EXPECT_DOUBLE_EQ(estimate.share, 0.9);
  EXPECT_DOUBLE_EQ(estimate.standard_error, std::sqrt(0.9 * 0.1 / 10.0));
}

// The share is (10 + 5) hits / 20 trials = 0.75. The residuals, hits - share * trials, are 2.5 and -2.5. Standard
// error: sqrt(groups / (groups - 1) * sum of squares) / trials = sqrt(2 * 12.5) / 20 = 0.25.
TEST(ShareEstimate, groups_that_differ_have_a_larger_error) {
  const ShareEstimate estimate = estimate_share({{10, 10}, {5, 10}});
  EXPECT_EQ(estimate.hits, 15);
  EXPECT_EQ(estimate.trials, 20);
  EXPECT_DOUBLE_EQ(estimate.share, 0.75);
  EXPECT_DOUBLE_EQ(estimate.standard_error, 0.25);
}

TEST(ShareEstimate, groups_that_agree_have_no_error) {
  EXPECT_DOUBLE_EQ(estimate_share({{9, 10}, {18, 20}}).standard_error, 0.0);
}

TEST(ShareEstimate, no_trials_give_no_share) { EXPECT_TRUE(std::isnan(estimate_share({}).share)); }

}  // namespace
}  // namespace lippmann::bench
