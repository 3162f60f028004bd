// When frames of a history err by too much.
#include "radiance/frame_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lippmann {
namespace {

FrameError error(float pixels, float uncertainty = 0.0f) { return {pixels, 0.5f * pixels, uncertainty, 0.5f * uncertainty}; }

TEST(FrameErrors, an_error_beyond_chance_is_too_large_at_once) {
  FrameErrors errors;
  errors.add(error(1.0f), error(2.0f));
  EXPECT_EQ(errors.pixels(), Excess::kNone);
  errors.add(error(4.1f, 1.0f), error(2.0f));  // 4.1 - 2 x 1 > 2
  EXPECT_EQ(errors.pixels(), Excess::kSure);
  EXPECT_EQ(errors.blocks(), Excess::kSure);
}

TEST(FrameErrors, one_uncertain_error_is_none_and_several_are) {
  FrameErrors errors;
  errors.add(error(1.0f, 0.2f), error(2.0f));
  errors.add(error(2.5f, 1.0f), error(2.0f));  // 2.5 - 2 x 1 < 2; the mean is (0.6 x 1 + 2.5) / 1.6 = 1.94
  EXPECT_EQ(errors.pixels(), Excess::kNone);
  for (int frame = 0; frame < 8; ++frame) errors.add(error(3.2f, 1.0f), error(2.0f));
  // Deviation of the mean: sqrt((1 - 0.6) / (1 + 0.6)) = 0.5, and 3.2 - 2 x 0.5 > 2.
  EXPECT_EQ(errors.pixels(), Excess::kSure);
}

TEST(FrameErrors, the_past_counts_less_and_less) {
  FrameErrors errors;
  errors.add(error(1.0f, 1.0f), error(1.0f));
  errors.add(error(2.0f, 1.0f), error(1.0f));
  EXPECT_FLOAT_EQ(errors.found().pixels, (0.6f * 1.0f + 2.0f) / 1.6f);
  errors.add(error(2.0f, 1.0f), error(1.0f));
  EXPECT_FLOAT_EQ(errors.found().pixels, (0.36f * 1.0f + 0.6f * 2.0f + 2.0f) / 1.96f);
  EXPECT_FLOAT_EQ(errors.allowed().pixels, 1.0f);
}

FrameError means(float blocks, float uncertainty) { return {0.5f, blocks, 0.5f, uncertainty}; }

// Half of what is allowed, then all of it, both give or take a half. The first is worth 0.25 + (0.2 * 0.5)^2 in the second.
TEST(FrameErrors, errors_of_means_are_pooled_by_how_certain_they_are) {
  FrameErrors errors;
  errors.add(means(1.0f, 1.0f), means(2.0f, 0.0f));
  EXPECT_FLOAT_EQ(errors.found().blocks, 1.0f);
  EXPECT_FLOAT_EQ(errors.found().block_uncertainty, 1.0f);
  errors.add(means(2.0f, 1.0f), means(2.0f, 0.0f));
  EXPECT_NEAR(errors.found().blocks, 2.0f * (0.5f + 0.5f * 0.26f / 0.51f), 1e-5f);
  EXPECT_NEAR(errors.found().block_uncertainty, 2.0f * std::sqrt(0.26f * 0.25f / 0.51f), 1e-5f);
}

// 1.9 of what is allowed, give or take 1.4, where 0.3, give or take 0.1, is expected.
TEST(FrameErrors, means_that_were_expected_to_be_good_are_not_too_large_by_one_uncertain_frame) {
  FrameErrors alone, expected;
  alone.add(means(1.9f, 1.4f), means(1.0f, 0.0f));
  EXPECT_EQ(alone.blocks(), Excess::kProbable);
  expected.expect_means({0.3f, 0.1f}, 1.0f);
  expected.add(means(1.9f, 1.4f), means(1.0f, 0.0f));
  EXPECT_EQ(expected.blocks(), Excess::kNone);
  EXPECT_NEAR(expected.found().blocks, 0.31f, 0.02f);
  expected.add(means(1.9f, 0.4f), means(1.0f, 0.0f));  // for sure
  EXPECT_EQ(expected.blocks(), Excess::kSure);
}

// Frames whose patches were lucky tell of little and seem to be sure of it. Weighed by their own variances, frames that err by
// what is allowed would seem to err by 0.54 of it.
TEST(FrameErrors, means_of_lucky_frames_count_no_more_than_others) {
  FrameErrors errors;
  double sum = 0.0;
  for (int frame = 0; frame < 40; ++frame) {
    errors.add(frame % 2 ? means(1.5f, 1.0f) : means(0.5f, 0.2f), means(1.0f, 0.0f));
    if (frame >= 20) sum += static_cast<double>(errors.found().blocks) / 20.0;
  }
  EXPECT_NEAR(sum, 1.0, 0.1);
}

// Another picture, as its pixels say for sure.
TEST(FrameErrors, what_was_known_of_means_counts_for_nothing_where_pixels_are_others) {
  FrameErrors errors;
  for (int frame = 0; frame < 8; ++frame) errors.add({1.0f, 0.1f, 0.01f, 0.5f}, {9.0f, 1.0f});
  errors.add({2.0f, 0.9f, 0.01f, 0.5f}, {9.0f, 1.0f});
  EXPECT_FLOAT_EQ(errors.found().blocks, 0.9f);
}

// 3 is 2.5 deviations of 0.71 from 1, and more.
TEST(FrameErrors, a_past_that_is_another_for_sure_counts_for_nothing) {
  FrameErrors errors;
  errors.add(error(1.0f, 0.5f), error(1.0f));
  errors.add(error(3.0f, 0.5f), error(2.0f));
  EXPECT_FLOAT_EQ(errors.found().pixels, 3.0f);
  EXPECT_FLOAT_EQ(errors.found().uncertainty, 0.5f);
  EXPECT_FLOAT_EQ(errors.allowed().blocks, 1.0f);
}

// What the first frame tells, half as much again as was expected, is the same in the second, in which four times as much was:
// 6, and the measured 6 agrees.
TEST(FrameErrors, frames_have_in_common_what_errors_are_in_parts_of_what_is_expected) {
  FrameErrors errors;
  errors.add(error(1.5f, 0.3f), error(9.0f), 1.0f);
  EXPECT_FLOAT_EQ(errors.of_latest().squared, 1.5f);
  EXPECT_FLOAT_EQ(errors.of_latest().uncertainty, 0.3f);
  errors.add(error(6.0f, 1.2f), error(9.0f), 4.0f);
  EXPECT_FLOAT_EQ(errors.of_latest().squared, 6.0f);
  // Both have a deviation of a fifth, and the past one of a fifth more: variances of 0.08 and 0.04 make one of 0.027.
  EXPECT_NEAR(errors.of_latest().uncertainty, 6.0f * std::sqrt(0.08f * 0.04f / (0.08f + 0.04f)), 1e-5f);
  EXPECT_FLOAT_EQ(errors.found().pixels, 6.0f);  // as an error by itself it is another, for sure
}

// Errors that are known to half of themselves, twofold: less than chance makes of it, so that the past counts for its
// certainty, 0.25 + 0.2^2, beside 0.25.
TEST(FrameErrors, without_anything_expected_errors_themselves_are_remembered) {
  FrameErrors errors;
  errors.add(error(1.0f, 0.5f), error(9.0f));
  errors.add(error(2.0f, 1.0f), error(9.0f));
  EXPECT_NEAR(errors.of_latest().squared, std::exp2(0.29f / 0.54f), 1e-5f);
}

// A quarter of what was expected, not all of it, both known to a tenth.
TEST(FrameErrors, of_parts_that_are_others_for_sure_next_to_nothing_is_kept) {
  FrameErrors errors;
  errors.add(error(1.0f, 0.1f), error(9.0f), 1.0f);
  errors.add(error(1.0f, 0.1f), error(9.0f), 4.0f);
  EXPECT_NEAR(errors.of_latest().squared, 1.0f, 0.02f);
}

// Lamps that switch on and off: what one frame tells of the next is known to be little after a few of them.
TEST(FrameErrors, parts_that_change_from_frame_to_frame_are_told_by_the_latest) {
  FrameErrors steady, switching;
  for (int frame = 0; frame < 8; ++frame) {
    steady.add(error(2.0f, 0.4f), error(9.0f), 2.0f);
    switching.add(error(2.0f, 0.4f), error(9.0f), frame % 2 ? 1.0f : 2.0f);
  }
  EXPECT_NEAR(switching.of_latest().squared, 2.0f, 0.15f);
  EXPECT_LT(steady.of_latest().uncertainty, 0.8f * 0.4f);
  EXPECT_GT(switching.of_latest().uncertainty, 0.85f * 0.4f);
}

}  // namespace
}  // namespace lippmann
