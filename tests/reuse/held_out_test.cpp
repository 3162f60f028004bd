#include "reuse/held_out.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lippmann {
namespace {

TEST(HeldOut, levels_follow_uncertainty) {
  EXPECT_EQ(level_of(0), 0);
  EXPECT_EQ(level_of(6), 6);
  EXPECT_EQ(level_of(7), 7);
  EXPECT_EQ(level_of(8), 7);
  EXPECT_EQ(level_of(9), 8);
  EXPECT_EQ(level_of(255), kUncertaintyLevels - 1);
  for (int uncertainty = 1; uncertainty < 256; ++uncertainty)
    EXPECT_GE(level_of(static_cast<std::uint8_t>(uncertainty)), level_of(static_cast<std::uint8_t>(uncertainty - 1)));
}

TEST(HeldOut, every_run_of_a_level_gives_one_patch) {
  // Patches alternate between two levels of uncertainty. hold_out() draws one of 30 patches of each level.
  std::vector<std::uint8_t> uncertainty(12000);
  for (std::size_t p = 0; p < uncertainty.size(); ++p) uncertainty[p] = p % 2 ? 30 : 0;
  ASSERT_EQ(patches_per_sample(uncertainty.size()), 30u);
  const HeldOut held_out = hold_out(uncertainty, 1, 2);
  ASSERT_EQ(held_out.patches.size(), 12000u / 30);
  std::array<std::size_t, 2> drawn{};
  for (std::size_t i = 0; i < held_out.patches.size(); ++i) {
    const std::uint32_t patch = held_out.patches[i], odd = patch % 2;
    EXPECT_EQ(held_out.levels[i], level_of(uncertainty[patch]));
    // One of 30 patches of a level is drawn. Every second patch has this level, so each 60 consecutive patches contain
    // one drawn patch.
    EXPECT_EQ(patch / 60, drawn[odd]++);
  }
  EXPECT_EQ(held_out.population[0], 6000u);
  EXPECT_EQ(held_out.population[static_cast<std::size_t>(level_of(30))], 6000u);
  EXPECT_EQ(held_out.drawn[0], drawn[0]);
  EXPECT_EQ(held_out.drawn[static_cast<std::size_t>(level_of(30))], drawn[1]);
}

TEST(HeldOut, other_frames_and_seeds_draw_other_patches) {
  const std::vector<std::uint8_t> uncertainty(12000, 5);
  const HeldOut first = hold_out(uncertainty, 1, 2);
  EXPECT_EQ(hold_out(uncertainty, 1, 2).patches, first.patches);
  EXPECT_NE(hold_out(uncertainty, 1, 3).patches, first.patches);
  EXPECT_NE(hold_out(uncertainty, 2, 2).patches, first.patches);
}

HeldOut drawn_by_hand() {
  HeldOut held_out{};
  held_out.population[0] = 100, held_out.population[2] = 50;
  held_out.drawn[0] = 4, held_out.drawn[2] = 2;
  held_out.patches = {1, 2, 3, 4, 5, 6};
  held_out.levels = {0, 0, 0, 0, 2, 2};
  return held_out;
}

Evidence evidence_of(const HeldOut& held_out, std::span<const double> squared_errors) {
  Evidence evidence;
  evidence.add(held_out, squared_errors);
  return evidence;
}

TEST(HeldOut, errors_are_weighted_by_untraced_patches) {
  const HeldOut held_out = drawn_by_hand();
  const auto errors = estimate_errors(held_out, evidence_of(held_out, std::vector<double>{0.0, 0.0, 0.0, 5.0, 200.0, 400.0}));
  // The draw has 150 patches, of which 96 of level 0 and 48 of level 2 are not traced. Samples of level 0 have a mean
  // error of (0 + 0 + 0 + 5) / 4 = 5/4, samples of level 2 a mean error of (200 + 400) / 2 = 300.
  EXPECT_NEAR(errors[0].mse, 96.0 / 150.0 * 1.25, 1e-12);
  EXPECT_NEAR(errors[1].mse, errors[0].mse, 1e-12);
  EXPECT_NEAR(errors[2].mse, errors[0].mse + 48.0 / 150.0 * 300.0, 1e-12);
  // The bound of level 0 is 2.326 standard deviations above the mean. Each of the 4 samples has the weight w = 96 /
  // (150 * 4) = 0.16, and their squared deviations sum to 25 - 4 (5/4)^2 = 18.75. The bound includes one more sample,
  // which was not drawn, with a squared error of 12^2 = 144.
  const double w = 0.16, not_drawn = w * 144.0;
  EXPECT_NEAR(errors[0].bound, 0.8 + not_drawn + 2.326 * std::sqrt(w * w * 18.75 + not_drawn * not_drawn), 1e-9);
  // For levels 0 and 2 together, the sample that was not drawn has the largest known squared error, 400.
  const double both = w * 400.0;
  EXPECT_NEAR(errors[2].bound, errors[2].mse + both + 2.326 * std::sqrt(w * w * (18.75 + 20000.0) + both * both), 1e-9);
}

TEST(HeldOut, learned_errors_count_like_own_samples) {
  const HeldOut held_out = drawn_by_hand();
  Evidence evidence = evidence_of(held_out, std::vector<double>{0.0, 0.0, 0.0, 4.0, 0.0, 0.0}), learned;
  learned.levels[0] = {36.0, 36.0, 72.0, 2.0};  // of 36 patches, 18 have an error of 2: the sum is 36, the sum of squares 72
  evidence.add(learned);
  const auto errors = estimate_errors(held_out, evidence);
  // 96 of 150 patches are of level 0 and not traced. With 4 own and 36 learned samples, level 0 has 40 samples. Their
  // errors sum to 4 + 36 = 40, and the squares of the errors to 16 + 72 = 88.
  EXPECT_NEAR(errors[0].mse, 96.0 / 150.0, 1e-12);
  const double w = 96.0 / (150.0 * 40.0), not_drawn = w * 144.0;
  EXPECT_NEAR(errors[0].bound, 0.64 + not_drawn + 2.326 * std::sqrt(w * w * 48.0 + not_drawn * not_drawn), 1e-9);
  evidence.weigh(0.5);
  EXPECT_NEAR(estimate_errors(held_out, evidence)[0].mse, errors[0].mse, 1e-12);
  EXPECT_GT(estimate_errors(held_out, evidence)[0].bound, errors[0].bound);
}

TEST(HeldOut, level_without_samples_uses_its_uncertainty) {
  HeldOut held_out = drawn_by_hand();
  held_out.population[3] = 50;
  const auto errors = estimate_errors(held_out, evidence_of(held_out, std::vector<double>(6, 0.0)));
  EXPECT_EQ(errors[2].mse, 0.0);
  // Without samples, the error is assumed to be the level's uncertainty of 3 codes, squared.
  EXPECT_NEAR(errors[3].mse, 50.0 / 200.0 * 9.0, 1e-12);
}

TEST(HeldOut, trust_ends_at_the_first_failing_level) {
  std::array<ErrorEstimate, kUncertaintyLevels> errors;
  for (std::size_t h = 0; h < errors.size(); ++h) errors[h].bound = 1.0;
  EXPECT_EQ(trusted_levels(errors, 1.0), kUncertaintyLevels);
  errors[5].bound = 1.1;
  EXPECT_EQ(trusted_levels(errors, 1.0), 5);
  EXPECT_EQ(trusted_levels(errors, 0.9), 0);
}

TEST(HeldOut, bound_holds_in_95_percent_of_samples) {
  // The squared errors have a log-normal distribution over four decades. All patches have one level, so that only the
  // bound is tested.
  constexpr int kTrials = 400;
  const std::vector<std::uint8_t> uncertainty(16000, 5);
  std::mt19937 random(3);
  std::lognormal_distribution<double> error(-2.0, 2.0);
  std::vector<double> errors(uncertainty.size());
  for (double& e : errors) e = error(random);
  int held = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const HeldOut held_out = hold_out(uncertainty, 7, trial);
    double truth = 0.0;
    for (const double e : errors) truth += e;
    std::vector<double> drawn;
    for (const std::uint32_t patch : held_out.patches) drawn.push_back(errors[patch]), truth -= errors[patch];
    held += estimate_errors(held_out, evidence_of(held_out, drawn))[5].bound >= truth / static_cast<double>(errors.size());
  }
  EXPECT_GE(held, kTrials * 95 / 100);
}

}  // namespace
}  // namespace lippmann
