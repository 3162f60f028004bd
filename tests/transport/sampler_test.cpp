#include "transport/sampler.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <vector>

namespace lippmann {
namespace {

// Elementary intervals: 2^k points of a (0, 2)-sequence put one into each box of 2^-i by 2^(i - k), for every i.
TEST(Sampler, sixteen_points_fill_every_elementary_interval_once) {
  for (const std::uint32_t seed : {0u, 1u, 77u, 0xdeadbeefu})
    for (const std::uint32_t first : {0u, 16u, 48u})
      for (int i = 0; i <= 4; ++i) {
        std::set<int> boxes;
        for (std::uint32_t n = first; n < first + 16; ++n) {
          const Vec2f p = scrambled_sobol(n, seed);
          boxes.insert(static_cast<int>(p.x * static_cast<float>(1 << i)) * 16 +
                       static_cast<int>(p.y * static_cast<float>(16 >> i)));
        }
        EXPECT_EQ(boxes.size(), 16u) << "seed " << seed << " from " << first << ", boxes 2^-" << i << " wide";
      }
}

TEST(Sampler, the_mean_over_seeds_is_a_half) {
  Vec2f sum(0.0f);
  constexpr int kSeeds = 4000;
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) sum += scrambled_sobol(5, seed);
  // Uniform numbers: standard deviation of the mean 0.2887 / sqrt(4000) = 0.0046; four of them.
  EXPECT_NEAR(sum.x / kSeeds, 0.5f, 0.0183f);
  EXPECT_NEAR(sum.y / kSeeds, 0.5f, 0.0183f);
}

TEST(Sampler, pairs_of_one_path_are_not_correlated) {
  double product = 0.0;
  constexpr int kPaths = 4096;
  for (std::uint32_t i = 0; i < kPaths; ++i) {
    PathSampler sampler(9u, i);
    const Vec2f a = sampler.next(), b = sampler.next();
    product += static_cast<double>((a.x - 0.5f) * (b.x - 0.5f));
  }
  // Independent: standard deviation 1/12 / sqrt(4096) = 0.0013.
  EXPECT_NEAR(product / kPaths, 0.0, 0.0052);
}

TEST(Sampler, jumping_to_a_pair_gives_its_numbers) {
  PathSampler straight(3u, 7u), jumping(3u, 7u);
  straight.next();
  straight.next();
  jumping.jump_to(2);
  EXPECT_EQ(straight.next(), jumping.next());
}

TEST(Sampler, paths_side_by_side_have_the_numbers_of_each_alone) {
  PathPairs paths;
  for (std::uint32_t i = 0; i < PathPairs::kPaths; ++i) {
    paths.seed[i] = 1000u * i + 7u;
    paths.index[i] = 3u * i;
    paths.first[i] = 4u * (i % 5u);
  }
  float x[PathPairs::kPaths], y[PathPairs::kPaths];
  sample_pairs(paths, 2, x, y);
  for (int i = 0; i < PathPairs::kPaths; ++i) {
    PathSampler alone(paths.seed[i], paths.index[i]);
    alone.jump_to(paths.first[i] + 2);
    EXPECT_EQ(alone.next(), Vec2f(x[i], y[i])) << i;
  }
}

}  // namespace
}  // namespace lippmann
