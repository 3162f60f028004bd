#include "lippmann/layout/precompensate.hpp"

#include <gmock/gmock.h>

#include "lippmann/optics/crosstalk.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

/// An eye sees 10 % of each neighbouring view. The tests neglect the weight of second neighbours, 6e-5. The tolerance
/// kNextButOne covers it.
const double kTenPercent = read_crosstalk("10%", "test");
constexpr float kNextButOne = 2e-4f;

Optics three_views() { return {.panel = {3, 1, 1.0f}, .model = MultiView{3, 1}}; }

Image views(float a, float b, float c) {
  Image image(3, 1, 3);
  for (int i = 0; i < 3; ++i) image.pixel(0, 0)[i] = a, image.pixel(1, 0)[i] = b, image.pixel(2, 0)[i] = c;
  return image;
}

// The panel shows (0.2, 0.7, 0.4). An eye sees its view with the weight 0.8 and each neighbour with 0.1. Outer views
// have one neighbour, so their sums are divided by 0.9. First view: (0.8 * 0.2 + 0.1 * 0.7) / 0.9 = 0.23 / 0.9. Second
// view: 0.1 * 0.2 + 0.8 * 0.7 + 0.1 * 0.4 = 0.62. Third view: (0.1 * 0.7 + 0.8 * 0.4) / 0.9 = 0.39 / 0.9.
TEST(Precompensate, three_views_are_solved_for) {
  Image image = views(0.23f / 0.9f, 0.62f, 0.39f / 0.9f);
  const Precompensation done = precompensate(three_views(), kTenPercent, "test", image);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(image.pixel(0, 0)[c], 0.2f, kNextButOne);
    EXPECT_NEAR(image.pixel(1, 0)[c], 0.7f, kNextButOne);
    EXPECT_NEAR(image.pixel(2, 0)[c], 0.4f, kNextButOne);
  }
  EXPECT_EQ(done.clipped_share, 0.0);
  EXPECT_LE(done.largest_residual, 1e-6);
}

// The views 0.5, 0, 0.5 would need negative light in the middle, which is clipped to 0. The outer views then need 0.9 * 0.5 /
// 0.8 = 0.5625. In the middle, an eye sees 2 * 0.1 * 0.5625 = 0.1125.
TEST(Precompensate, clips_negative_light_and_adjusts_neighbours) {
  Image image = views(0.5f, 0.0f, 0.5f);
  const Precompensation done = precompensate(three_views(), kTenPercent, "test", image);
  EXPECT_NEAR(image.pixel(0, 0)[0], 0.5625f, kNextButOne);
  EXPECT_EQ(image.pixel(1, 0)[0], 0.0f);
  EXPECT_NEAR(image.pixel(2, 0)[0], 0.5625f, kNextButOne);
  EXPECT_NEAR(done.clipped_share, 1.0 / 3, 1e-9);
  EXPECT_NEAR(done.largest_residual, 0.1125, 2e-4);
}

// Black next to white needs light below 0 and above 1, so no correction is possible. The eye of the middle view sees 0.2
// instead of black, those of the outer views see 0.8 / 0.9 = 0.89 instead of white.
TEST(Precompensate, full_contrast_misses_by_the_neighbour_share) {
  Image image = views(1.0f, 0.0f, 7.0f);  // values above 1 are shown as white
  const Precompensation done = precompensate(three_views(), kTenPercent, "test", image);
  EXPECT_EQ(image.data, views(1.0f, 0.0f, 1.0f).data);
  EXPECT_EQ(done.clipped_share, 1.0);
  EXPECT_NEAR(done.largest_residual, 0.2, 1e-3);
}

TEST(Precompensate, even_pictures_and_no_crosstalk_change_nothing) {
  for (const float level : {0.0f, 0.3f, 1.0f}) {
    Image image = views(level, level, level);
    EXPECT_EQ(precompensate(three_views(), kTenPercent, "test", image).clipped_share, 0.0);
    for (const float value : image.data) EXPECT_NEAR(value, level, 1e-6);
  }
  Image image = views(0.1f, 0.9f, 0.2f);
  EXPECT_EQ(precompensate(three_views(), 0.0, "test", image), Precompensation{});
  EXPECT_EQ(image.data, views(0.1f, 0.9f, 0.2f).data);
}

// In a lenticular sheet, light leaks only to neighbours in the row, also below another lens, and never between colours.
TEST(Precompensate, neighbours_are_those_on_the_panel) {
  Optics sheet{.panel = {16, 2, 0.125f}, .model = LenticularSheet{}};
  Image image(16, 2, 3);
  for (int i = 0; i < 96; ++i) image.data[static_cast<std::size_t>(i)] = 0.5f;
  image.pixel(7, 1)[1] = 0.6f;
  precompensate(sheet, kTenPercent, "test", image);
  EXPECT_GT(image.pixel(7, 1)[1], 0.62f);
  EXPECT_LT(image.pixel(8, 1)[1], 0.49f);
  EXPECT_NEAR(image.pixel(7, 0)[1], 0.5f, 1e-6);
  EXPECT_NEAR(image.pixel(7, 1)[0], 0.5f, 1e-6);
}

// An eye sees 0.8 of a pixel's light along each axis, 0.64 along both. To appear 0.2 brighter, a pixel must be shown
// about 0.2 / 0.64 brighter.
TEST(Precompensate, lenslets_and_grids_leak_along_both_axes) {
  Optics lenslets{.panel = {33, 33, 0.125f}, .model = MicrolensArray{}};
  Optics grid{.panel = {33, 33, 1.0f}, .model = MultiView{.columns = 33, .rows = 33, .baseline_mm = 1.0f}};
  std::vector<Image> made;
  for (const Optics& optics : {lenslets, grid}) {
    Image image(33, 33, 3);
    for (float& value : image.data) value = 0.5f;
    image.pixel(16, 16)[0] = 0.7f;
    EXPECT_EQ(precompensate(optics, kTenPercent, "test", image).clipped_share, 0.0);
    EXPECT_GT(image.pixel(16, 16)[0], 0.5f + 0.2f / 0.64f);
    EXPECT_NEAR(image.pixel(17, 16)[0], image.pixel(16, 17)[0], 1e-5);
    made.push_back(image);
  }
  EXPECT_EQ(made[0].data, made[1].data);
}

TEST(Precompensate, what_cannot_be_told_apart_is_refused) {
  Image image = views(0.1f, 0.9f, 0.2f);
  EXPECT_THAT(test::error_message([&] { precompensate(three_views(), 1.0, "--precompensate", image); }),
              HasSubstr("too strong to be compensated"));
  EXPECT_THAT(test::error_message([&] {
                precompensate({.panel = {3, 1, 1.0f}, .model = SingleView{}}, 0.1, "--x", image);
              }),
              HasSubstr("no neighbours"));
}

}  // namespace
}  // namespace lippmann
