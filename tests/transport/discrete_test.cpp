#include "transport/discrete.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace lippmann {
namespace {

TEST(DiscreteDistribution, finds_the_interval_of_a_number) {
  const DiscreteDistribution d(std::array{1.0f, 0.0f, 2.0f, 1.0f, 0.0f});  // cumulative probabilities: .25, .25, .75, 1, 1
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

TEST(DiscreteDistribution, uneven_weights_are_drawn_proportionally) {
  std::vector<float> weights;
  for (int i = 0; i < 1000; ++i) weights.push_back(i % 7 == 0 ? 0.0f : i % 50 == 1 ? 400.0f : 1.0f);
  const DiscreteDistribution d(weights);
  std::vector<int> found(weights.size());
  constexpr int kDraws = 1 << 20;
  for (int i = 0; i < kDraws; ++i) {
    float rest = -1.0f;
    ++found[d.sample(static_cast<float>(i) / kDraws, rest)];
    ASSERT_GE(rest, 0.0f);
    ASSERT_LT(rest, 1.0f);
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    EXPECT_NEAR(found[i], kDraws * static_cast<double>(weights[i]) / d.total(), 2.0) << i;
    EXPECT_NEAR(d.probability(i), static_cast<double>(weights[i]) / d.total(), 1e-6) << i;
  }
}

TEST(DiscreteDistribution, of_nothing_is_empty) {
  EXPECT_TRUE(DiscreteDistribution(std::array{0.0f, 0.0f}).empty());
  EXPECT_TRUE(DiscreteDistribution().empty());
}

}  // namespace
}  // namespace lippmann
