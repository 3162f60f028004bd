#include "transport/discrete.hpp"

#include <gtest/gtest.h>

#include <array>

namespace lippmann {
namespace {

TEST(DiscreteDistribution, finds_the_share_that_a_number_falls_into) {
  const DiscreteDistribution d(std::array{1.0f, 0.0f, 2.0f, 1.0f, 0.0f});  // shares end at .25, .25, .75, 1, 1
  float rest = -1.0f;
  EXPECT_EQ(d.sample(0.0f, rest), 0u);
  EXPECT_EQ(d.sample(0.25f, rest), 2u);
  EXPECT_FLOAT_EQ(rest, 0.0f);
  EXPECT_EQ(d.sample(0.5f, rest), 2u);
  EXPECT_FLOAT_EQ(rest, 0.5f);
  EXPECT_EQ(d.sample(0x1.fffffep-1f, rest), 3u);
  EXPECT_LT(rest, 1.0f);
  EXPECT_FLOAT_EQ(d.probability(2), 0.5f);
  EXPECT_FLOAT_EQ(d.probability(1), 0.0f);
  EXPECT_FLOAT_EQ(d.probability(4), 0.0f);
  EXPECT_DOUBLE_EQ(d.total(), 4.0);
}

TEST(DiscreteDistribution, of_nothing_is_empty) {
  EXPECT_TRUE(DiscreteDistribution(std::array{0.0f, 0.0f}).empty());
  EXPECT_TRUE(DiscreteDistribution().empty());
}

}  // namespace
}  // namespace lippmann
