#include "lippmann/image/tone.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

TEST(Tone, exposure_doubles_light_by_the_stop) {
  const Vec3f color = apply_tone({1.0f, ToneCurve::kNone}, {0.1f, 0.3f, 2.0f});
  EXPECT_FLOAT_EQ(color.x, 0.2f);
  EXPECT_FLOAT_EQ(color.z, 4.0f);
}

// The smallest channel, 0.2, is at least 0.08, so 0.04 is subtracted from all channels. The largest result, 0.46, is
// below 0.76, so nothing is compressed.
TEST(Tone, neutral_subtracts_only_fresnel_reflection) {
  const Vec3f color = apply_tone({0.0f, ToneCurve::kNeutral}, {0.5f, 0.2f, 0.3f});
  EXPECT_NEAR(color.x, 0.46f, 1e-6f);
  EXPECT_NEAR(color.y, 0.16f, 1e-6f);
  EXPECT_NEAR(color.z, 0.26f, 1e-6f);
}

// Subtracting 0.04 from the grey 2 gives the peak 1.96, which is compressed to 1 - 0.24^2 / (1.96 + 0.24 - 0.76) =
// 0.96.
TEST(Tone, neutral_brings_bright_grey_below_white) {
  const Vec3f color = apply_tone({0.0f, ToneCurve::kNeutral}, Vec3f(2.0f));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(color[c], 0.96f, 1e-5f);
}

TEST(Tone, curves_are_monotonic_up_to_white) {
  for (const ToneCurve curve : {ToneCurve::kNeutral, ToneCurve::kAgx}) {
    float last = -1.0f;
    for (float light = 1e-4f; light < 1e6f; light *= 1.5f) {
      const float shown = apply_tone({0.0f, curve}, Vec3f(light)).x;
      EXPECT_GE(shown, last) << light;
      EXPECT_LE(shown, 1.0f) << light;
      last = shown;
    }
    EXPECT_GT(last, 0.95f);
    EXPECT_NEAR(apply_tone({0.0f, curve}, Vec3f(0.0f)).x, 0.0f, 1e-3f);
  }
}

// Middle grey is 0.18 in linear light, the sRGB code 118.
TEST(Tone, agx_keeps_middle_grey) {
  const Vec3f grey = apply_tone({0.0f, ToneCurve::kAgx}, Vec3f(0.18f));
  EXPECT_NEAR(grey.x, 0.18f, 0.04f);
  EXPECT_NEAR(grey.x, grey.y, 1e-3f);
  EXPECT_NEAR(grey.y, grey.z, 1e-3f);
}

TEST(Tone, a_film_is_changed_pixel_by_pixel) {
  Image film(2, 1, 3);
  film.data = {0.1f, 0.2f, 0.3f, 1.0f, 2.0f, 3.0f};
  apply_tone(Tone{-1.0f, ToneCurve::kNone}, film);
  EXPECT_EQ(film.data, (std::vector<float>{0.05f, 0.1f, 0.15f, 0.5f, 1.0f, 1.5f}));
}

}  // namespace
}  // namespace lippmann
