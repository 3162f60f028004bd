// Which pixels of a film an eye sees at once.
#include "optics/eye_blur.hpp"

#include <gtest/gtest.h>

#include "lippmann/optics/crosstalk.hpp"

namespace lippmann {
namespace {

constexpr double kTenPercent = 0.39;  ///< the sigma of which each neighbour has a tenth

Optics quilt(int columns, int rows, float baseline_mm = 0.0f) {
  Optics optics;
  optics.panel = {columns * 10, rows * 6 + 1, 1.0f};  // a row of padding on top
  MultiView views;
  views.columns = columns, views.rows = rows, views.baseline_mm = baseline_mm;
  optics.model = views;
  return optics;
}

Optics panel_with(const OpticsModel& model) {
  Optics optics;
  optics.panel = {64, 32, 0.125f};
  optics.model = model;
  return optics;
}

std::optional<std::uint32_t> at(int x, int y, int width) { return static_cast<std::uint32_t>(y * width + x); }

TEST(EyeBlur, of_sharp_lenses_and_single_views_shows_a_pixel_alone) {
  for (const EyeBlur& blur : {EyeBlur(quilt(8, 1), 0.0), EyeBlur(panel_with(SingleView{}), 0.4)}) {
    EXPECT_FALSE(blur.blurs());
    EXPECT_EQ(blur.own_share(), 1.0);
    EXPECT_EQ(blur.weight(Vec2i(0)), 1.0);
    EXPECT_EQ(blur.draw_overlapping({0.99, 0.99}), Vec2i(0));
  }
}

// 0.8, and a tenth on each side: squares add up to 0.64 + 0.02.
TEST(EyeBlur, leaves_independent_errors_the_sum_of_squared_weights) {
  const EyeBlur sheet(panel_with(LenticularSheet{}), kTenPercent);
  EXPECT_NEAR(sheet.weight({1, 0}), 0.1, 1e-3);
  EXPECT_NEAR(sheet.own_share(), 0.66, 3e-3);
  EXPECT_EQ(sheet.reach(), Vec2i(1, 0));
  const EyeBlur lenslets(panel_with(MicrolensArray{}), kTenPercent);
  EXPECT_NEAR(lenslets.own_share(), sheet.own_share() * sheet.own_share(), 1e-12);
  EXPECT_NEAR(lenslets.weight({1, -1}), 0.01, 2e-4);
  // A Gaussian of many pixels is that of 2 sqrt(pi) sigma independent ones.
  EXPECT_NEAR(EyeBlur(panel_with(LenticularSheet{}), 5.0).own_share(), 1.0 / (2.0 * std::sqrt(M_PI) * 5.0), 5e-4);
}

TEST(EyeBlur, weights_and_overlaps_add_up_to_one) {
  for (const double sigma : {0.2, 0.5, 3.0, kMaxBlurPx}) {
    const EyeBlur blur(panel_with(LenticularSheet{}), sigma);
    double weights = 0.0, overlaps = 0.0;
    for (int step = -2 * blur.reach().x; step <= 2 * blur.reach().x; ++step)
      weights += blur.weight({step, 0}), overlaps += blur.overlap({step, 0});
    EXPECT_NEAR(weights, 1.0, 1e-12) << sigma;
    EXPECT_NEAR(overlaps, 1.0, 1e-12) << sigma;
  }
}

TEST(EyeBlur, steps_are_drawn_as_often_as_they_overlap) {
  const EyeBlur blur(panel_with(LenticularSheet{}), 0.5);
  constexpr int kDraws = 10000;
  int ones = 0;
  for (int i = 0; i < kDraws; ++i) ones += blur.draw_overlapping({(i + 0.5) / kDraws, 0.5}) == Vec2i(1, 0) ? 1 : 0;
  EXPECT_NEAR(ones / static_cast<double>(kDraws), blur.overlap({1, 0}), 2e-4);
}

TEST(EyeBlur, neighbours_of_a_panel_lie_beside_a_pixel_and_nothing_lies_beyond) {
  const EyeBlur blur(panel_with(MicrolensArray{}), 0.5);
  EXPECT_EQ(blur.neighbour(5 * 64 + 7, {2, -1}), at(9, 4, 64));
  EXPECT_FALSE(blur.neighbour(5 * 64 + 63, {1, 0}));
  EXPECT_FALSE(blur.neighbour(63, {0, -1}));
}

TEST(EyeBlur, neighbours_on_a_slanted_panel_are_sub_pixels_of_the_same_colour) {
  const EyeBlur blur(panel_with(SlantedPanel{}), 0.5);
  EXPECT_EQ(blur.neighbour(2 * 192 + 10, {1, 0}), at(13, 2, 192));
}

// View 3 of 4 x 2 is the last of the lower row, view 4 the first of the upper one: neighbours in the cone, but not in a grid.
TEST(EyeBlur, neighbours_in_a_quilt_are_the_same_pixel_of_the_next_views) {
  const EyeBlur cone(quilt(4, 2), 0.5), grid(quilt(4, 2, 1.0f), 0.5);
  const auto lower = *at(32, 7 + 2, 40);
  EXPECT_EQ(cone.neighbour(lower, {-1, 0}), at(22, 9, 40));
  EXPECT_EQ(cone.neighbour(lower, {1, 0}), at(2, 1 + 2, 40));
  EXPECT_FALSE(cone.neighbour(lower, {5, 0}));
  EXPECT_FALSE(grid.neighbour(lower, {1, 0}));
  EXPECT_EQ(grid.neighbour(lower, {0, 1}), at(32, 3, 40));
  EXPECT_FALSE(grid.neighbour(lower, {0, -1}));
  EXPECT_FALSE(cone.neighbour(5, {1, 0})) << "padding";
}

}  // namespace
}  // namespace lippmann
