// When frames of a history err by too much.
#include "radiance/frame_errors.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

FrameError error(float pixels, float uncertainty = 0.0f) { return {pixels, 0.5f * pixels, uncertainty, 0.5f * uncertainty}; }

TEST(FrameErrors, an_error_beyond_doubt_is_too_large_at_once) {
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
  errors.add(error(3.0f, 1.0f), error(2.0f));  // 3 - 2 x 1 < 2; the mean, (0.6 x 1 + 3) / 1.6 = 2.25, is no more than 2 x 1.15
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
  EXPECT_FLOAT_EQ(errors.found().blocks, 0.5f * errors.found().pixels);
  EXPECT_FLOAT_EQ(errors.allowed().pixels, 1.0f);
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

}  // namespace
}  // namespace lippmann
