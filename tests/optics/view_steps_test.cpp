#include "optics/view_steps.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace lippmann {
namespace {

using Pixels = std::vector<std::uint32_t>;

Pixels walked(const ViewSteps& steps, std::uint32_t pixel, StepDirection direction) {
  Pixels pixels;
  ViewWalk walk = steps.walk(pixel, direction);
  for (auto at = walk.next(); at; at = walk.next()) pixels.push_back(*at);
  return pixels;
}

Optics sheet() {
  Optics optics;
  optics.panel = {16, 3, 0.25f};
  optics.model = LenticularSheet{};
  return optics;
}

TEST(ViewSteps, sheet_views_step_by_lenses) {
  const ViewSteps steps(sheet(), StepsWithin::kView);
  const std::uint32_t pixel = 16 + 6;
  EXPECT_EQ(walked(steps, pixel, StepDirection::kLeft), (Pixels{16 + 2}));
  EXPECT_EQ(walked(steps, pixel, StepDirection::kRight), (Pixels{16 + 10, 16 + 14}));
  EXPECT_EQ(walked(steps, pixel, StepDirection::kUp), (Pixels{6}));
  EXPECT_EQ(walked(steps, pixel, StepDirection::kDown), (Pixels{32 + 6}));
  EXPECT_FLOAT_EQ(steps.length_px(StepDirection::kRight), 4.0f);
  EXPECT_FLOAT_EQ(steps.length_px(StepDirection::kDown), 1.0f);
}

TEST(ViewSteps, sheet_lenses_end_at_the_cell) {
  const ViewSteps steps(sheet(), StepsWithin::kLens);
  const std::uint32_t pixel = 16 + 6;
  EXPECT_EQ(walked(steps, pixel, StepDirection::kLeft), (Pixels{16 + 5, 16 + 4}));
  EXPECT_EQ(walked(steps, pixel, StepDirection::kRight), (Pixels{16 + 7}));
  EXPECT_EQ(walked(steps, pixel, StepDirection::kDown), (Pixels{32 + 6}));
}

TEST(ViewSteps, microlenses_step_by_lenses_or_pixels) {
  Optics optics;
  optics.panel = {12, 12, 0.25f};
  optics.model = MicrolensArray{.offset_mm = {0.0f, 0.0f}};
  const std::uint32_t pixel = 5 * 12 + 6;
  const ViewSteps views(optics, StepsWithin::kView), lens(optics, StepsWithin::kLens);
  EXPECT_EQ(walked(views, pixel, StepDirection::kRight), (Pixels{5 * 12 + 10}));
  EXPECT_EQ(walked(views, pixel, StepDirection::kDown), (Pixels{9 * 12 + 6}));
  EXPECT_EQ(walked(lens, pixel, StepDirection::kRight), (Pixels{5 * 12 + 7}));
  EXPECT_EQ(walked(lens, pixel, StepDirection::kDown), (Pixels{6 * 12 + 6, 7 * 12 + 6}));
}

TEST(ViewSteps, hexagonal_views_step_by_two_rows) {
  Optics optics;
  optics.panel = {40, 40, 0.1f};
  optics.model = MicrolensArray{.packing = LensPacking::kHexagonal};
  const ViewSteps steps(optics, StepsWithin::kView);
  EXPECT_FLOAT_EQ(steps.length_px(StepDirection::kRight), 10.0f);
  EXPECT_NEAR(steps.length_px(StepDirection::kDown), 10.0f * std::sqrt(3.0f), 1e-4f);
}

TEST(ViewSteps, quilt_views_end_at_their_tile) {
  Optics optics;
  optics.panel = {8, 6, 1.0f};
  optics.model = MultiView{.columns = 2, .rows = 2};
  const ViewSteps steps(optics, StepsWithin::kView);
  const std::uint32_t pixel = 1 * 8 + 5;  // a pixel of the top right tile of 4 x 3 pixels
  EXPECT_EQ(walked(steps, pixel, StepDirection::kLeft), (Pixels{1 * 8 + 4}));
  EXPECT_EQ(walked(steps, pixel, StepDirection::kRight), (Pixels{1 * 8 + 6, 1 * 8 + 7}));
  EXPECT_EQ(walked(steps, pixel, StepDirection::kUp), (Pixels{5}));
  EXPECT_EQ(walked(steps, pixel, StepDirection::kDown), (Pixels{2 * 8 + 5}));
}

TEST(ViewSteps, padding_belongs_to_the_adjacent_tile) {
  Optics optics;
  optics.panel = {9, 7, 1.0f};  // the four tiles of 4 x 3 pixels leave a column at the right and a row at the top
  optics.model = MultiView{.columns = 2, .rows = 2};
  const ViewSteps steps(optics, StepsWithin::kView);
  EXPECT_EQ(walked(steps, 1 * 9 + 7, StepDirection::kRight), (Pixels{1 * 9 + 8}));
  EXPECT_EQ(walked(steps, 1 * 9 + 7, StepDirection::kUp), (Pixels{7}));
  EXPECT_EQ(walked(steps, 4 * 9 + 7, StepDirection::kUp), Pixels{});
}

TEST(ViewSteps, single_view_is_walked_pixel_by_pixel) {
  Optics optics;
  optics.panel = {4, 3, 1.0f};
  optics.model = SingleView{};
  const ViewSteps steps(optics, StepsWithin::kView);
  EXPECT_EQ(walked(steps, 4 + 1, StepDirection::kRight), (Pixels{4 + 2, 4 + 3}));
  EXPECT_EQ(walked(steps, 4 + 1, StepDirection::kUp), (Pixels{1}));
}

}  // namespace
}  // namespace lippmann
