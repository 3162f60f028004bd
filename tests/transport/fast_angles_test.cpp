#include "transport/fast_angles.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

// slightly more than the distance between floats next to pi
constexpr float kTolerance = 3e-7f;

TEST(FastAngles, arc_tangents_match_the_library) {
  for (int i = 0; i < 100'000; ++i) {
    const float angle = 2.0f * kPi * (static_cast<float>(i) + 0.5f) / 100'000.0f;
    const float y = 3.0f * std::sin(angle), x = 3.0f * std::cos(angle);
    ASSERT_NEAR(fast_atan2(y, x), std::atan2(y, x), kTolerance) << angle;
  }
}

TEST(FastAngles, arc_tangents_on_axes_are_exact) {
  EXPECT_EQ(fast_atan2(0.0f, 2.0f), 0.0f);
  EXPECT_EQ(fast_atan2(0.0f, -2.0f), kPi);
  EXPECT_EQ(fast_atan2(2.0f, 0.0f), 0.5f * kPi);
  EXPECT_EQ(fast_atan2(-2.0f, 0.0f), -0.5f * kPi);
  EXPECT_EQ(fast_atan2(0.0f, 0.0f), 0.0f);
}

TEST(FastAngles, arc_cosines_match_the_library) {
  for (int i = 0; i <= 100'000; ++i) {
    const float x = static_cast<float>(i - 50'000) / 50'000.0f;
    ASSERT_NEAR(fast_acos(x), std::acos(x), kTolerance) << x;
  }
  EXPECT_EQ(fast_acos(1.0f), 0.0f);
  EXPECT_EQ(fast_acos(-1.0f), kPi);
}

TEST(FastAngles, sines_and_cosines_match_the_library) {
  for (int i = -400'000; i <= 400'000; ++i) {
    const float angle = static_cast<float>(i) * (10.0f / 400'000.0f);
    float sine, cosine;
    fast_sin_cos(angle, sine, cosine);
    ASSERT_NEAR(sine, std::sin(angle), 2e-7f) << angle;
    ASSERT_NEAR(cosine, std::cos(angle), 2e-7f) << angle;
  }
}

}  // namespace
}  // namespace lippmann
