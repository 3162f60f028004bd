// How many paths make up for what a cache is wrong about.
#include "radiance/path_mix.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace lippmann {
namespace {

// Paths of which 64 err by 1 in pixels and, over blocks of 64, by 1 / 64 in means, of which 2 / 64 are allowed.
constexpr PathErrors kPaths{{64.0f, 1.0f}};
constexpr MixedErrors kMay{1.0f, 2.0f / 64.0f};

float excess(const MixedErrors& e) { return std::max(e.pixels / kMay.pixels, e.blocks / kMay.blocks); }

TEST(PathMix, errs_by_the_squares_of_the_weights) {
  const MixedErrors e = errors_of({16, 0.25f}, {0.5f, 0.08f}, kPaths);
  EXPECT_FLOAT_EQ(e.pixels, 0.5625f * 0.5f + 0.0625f * 4.0f);
  EXPECT_FLOAT_EQ(e.blocks, 0.5625f * 0.08f + 0.0625f / 16.0f);
  EXPECT_FLOAT_EQ(errors_of({}, {0.5f, 0.08f}, kPaths).pixels, 0.5f);
}

// 32 paths of an exponent of 1.5 leave 32^-1.5 = 0.00552 of the error of one; 37 are 32 + 4 + 1 of them: (5.657 + 2 + 1) / 37^2
// = 0.00632, more than 32 do.
TEST(PathMix, paths_of_a_power_of_two_are_worth_more) {
  const PathErrors noise{{1.0f, 1.0f}, 1.0f}, edges{{1.0f, 1.0f}, 1.5f};
  EXPECT_FLOAT_EQ(noise.of(37).pixels, 1.0f / 37.0f);
  EXPECT_NEAR(edges.of(32).pixels, 0.005524f, 1e-6f);
  EXPECT_NEAR(edges.of(37).pixels, 0.00632f, 1e-5f);
  EXPECT_FLOAT_EQ(PathErrors::with({0.5f, 0.1f}, 37, 1.5f).of(37).blocks, 0.1f);
}

TEST(PathMix, a_good_picture_needs_no_paths) { EXPECT_EQ(mix_for({0.9f, 0.03f}, kPaths, kMay, 64)->samples, 0); }

// Means that err by three times what 64 paths do: 1 / (1 / 3 + n / 64) <= 2 needs 11 paths, with the weight n / 64 / (1 / 3 +
// n / 64) = 0.34; what these do to pixels is allowed.
TEST(PathMix, takes_as_few_paths_as_do) {
  const MixedErrors cached{0.3f, 3.0f / 64.0f};
  const std::optional<PathMix> mix = mix_for(cached, kPaths, kMay, 64);
  ASSERT_TRUE(mix);
  EXPECT_EQ(mix->samples, 11);
  EXPECT_NEAR(mix->weight, 0.34f, 0.04f);
  EXPECT_LE(excess(errors_of(*mix, cached, kPaths)), 1.0f);
  EXPECT_FALSE(mix_for(cached, kPaths, kMay, 10));
}

// Both err by too much.
TEST(PathMix, keeps_pixels_and_means_alike) {
  const MixedErrors cached{2.0f, 4.0f / 64.0f};
  const std::optional<PathMix> mix = mix_for(cached, kPaths, kMay, 64);
  ASSERT_TRUE(mix);
  const MixedErrors e = errors_of(*mix, cached, kPaths);
  EXPECT_LE(e.pixels, kMay.pixels);
  EXPECT_LE(e.blocks, kMay.blocks);
}

TEST(PathMix, grows_and_falls_with_the_weight_of_as_many_paths) {
  EXPECT_EQ(scaled({}, 2.0f, 64).samples, 0);
  const PathMix twice = scaled({10, 0.5f}, 2.0f, 64), less = scaled({10, 0.5f}, 0.75f, 64), none = scaled({1, 0.5f}, 0.75f, 64);
  EXPECT_EQ(twice.samples, 24);  // 20, spread evenly
  EXPECT_FLOAT_EQ(twice.weight, 24.0f / 34.0f);
  EXPECT_EQ(less.samples, 6);  // 7
  EXPECT_FLOAT_EQ(less.weight, 6.0f / 16.0f);
  EXPECT_EQ(none.samples, 0);
  EXPECT_EQ(scaled({50, 0.5f}, 2.0f, 64).samples, 64);
}

}  // namespace
}  // namespace lippmann
