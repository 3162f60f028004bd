#include "transport/sampler.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <vector>

namespace lippmann {
namespace {

// 16 = 2^4 points of a (0, 2)-sequence put one point into each box of width 2^-i and height 2^(i - 4), for i from 0 to 4.
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
  // Four standard deviations of the mean of uniform numbers, 0.2887 / sqrt(4000) = 0.0046.
  EXPECT_NEAR(sum.x / kSeeds, 0.5f, 0.0183f);
  EXPECT_NEAR(sum.y / kSeeds, 0.5f, 0.0183f);
}

std::vector<Vec2f> pairs_of(std::uint32_t seed, std::uint32_t first_index, std::uint32_t first, std::uint32_t pair) {
  PathPairs paths;
  for (std::uint32_t i = 0; i < PathPairs::kPaths; ++i)
    paths.seed[i] = seed, paths.index[i] = first_index + i, paths.first[i] = first;
  float x[PathPairs::kPaths], y[PathPairs::kPaths];
  sample_pairs(paths, pair, x, y);
  std::vector<Vec2f> pairs;
  for (int i = 0; i < PathPairs::kPaths; ++i) pairs.push_back({x[i], y[i]});
  return pairs;
}

TEST(Sampler, pairs_of_one_path_are_not_correlated) {
  double product = 0.0;
  constexpr std::uint32_t kPaths = 4096;
  for (std::uint32_t first = 0; first < kPaths; first += PathPairs::kPaths) {
    const std::vector<Vec2f> a = pairs_of(9u, first, 0, 0), b = pairs_of(9u, first, 0, 1);
    for (std::size_t i = 0; i < a.size(); ++i) product += static_cast<double>((a[i].x - 0.5f) * (b[i].x - 0.5f));
  }
  // Four standard deviations of the mean product of independent numbers, 1/12 / sqrt(4096) = 0.0013.
  EXPECT_NEAR(product / kPaths, 0.0, 0.0052);
}

TEST(Sampler, paths_are_stratified_in_every_pair) {
  for (std::uint32_t pair = 0; pair < 5; ++pair) {
    std::set<int> columns, rows;
    for (const Vec2f p : pairs_of(3u, 32u, 0, pair))
      columns.insert(static_cast<int>(16.0f * p.x)), rows.insert(static_cast<int>(16.0f * p.y));
    EXPECT_EQ(columns.size(), 16u) << pair;
    EXPECT_EQ(rows.size(), 16u) << pair;
  }
}

TEST(Sampler, later_first_pair_skips_pairs) { EXPECT_EQ(pairs_of(3u, 7u, 2, 1), pairs_of(3u, 7u, 0, 3)); }

TEST(Sampler, lanes_are_independent) {
  PathPairs paths;
  for (std::uint32_t i = 0; i < PathPairs::kPaths; ++i) {
    paths.seed[i] = 1000u * i + 7u;
    paths.index[i] = 3u * i;
    paths.first[i] = 4u * (i % 5u);
  }
  float x[PathPairs::kPaths], y[PathPairs::kPaths];
  sample_pairs(paths, 2, x, y);
  for (std::size_t i = 0; i < PathPairs::kPaths; ++i)
    EXPECT_EQ(pairs_of(paths.seed[i], paths.index[i], paths.first[i], 2)[0], Vec2f(x[i], y[i])) << i;
}

}  // namespace
}  // namespace lippmann
