// The figures of path-traced light, on pictures of a few pixels.
#include "bench/light_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "image/metrics.hpp"

namespace lippmann::bench {
namespace {

/// Grey pixels.
Image8 picture(int width, int height, const std::vector<unsigned char>& greys) {
  Image8 image{width, height, {}};
  for (const unsigned char grey : greys) image.rgb.insert(image.rgb.end(), 3, grey);
  return image;
}

Optics lenticular(int width, int height, int lens_pixels) {
  Optics optics;
  optics.panel = {width, height, 1.0f / static_cast<float>(lens_pixels)};
  LenticularSheet sheet;
  sheet.viewing_distance_mm = kInfinity;
  sheet.offset_mm = 0.5f;
  optics.model = sheet;
  return optics;
}

Optics quilt(int columns, int rows, int tile) {
  Optics optics;
  optics.panel = {columns * tile, rows * tile, 1.0f};
  MultiView views;
  views.columns = columns, views.rows = rows;
  optics.model = views;
  return optics;
}

TEST(LightFigures, a_reference_against_itself_has_infinite_psnr) {
  const Frames frames{picture(2, 1, {3, 200}), picture(2, 1, {0, 255})};
  EXPECT_TRUE(std::isinf(psnr_db(mean_squared_error(frames, frames))));
}

TEST(LightFigures, error_is_the_mean_over_all_frames) {
  const Frames reference{picture(2, 1, {10, 20}), picture(2, 1, {30, 40})};
  const Frames test{picture(2, 1, {12, 20}), picture(2, 1, {30, 44})};
  EXPECT_DOUBLE_EQ(mean_squared_error(reference, test), (4.0 + 16.0) / 4.0);
}

TEST(LightFigures, view_flicker_is_the_second_difference_below_a_lens_and_not_across_lenses) {
  const auto views = neighbouring_views(lenticular(8, 1, 4), {0});
  ASSERT_EQ(views.size(), 4u);  // two of four pixels have neighbours on both sides
  // Lens 1: 0 0 10 0: |0 - 0 + 10|, |0 - 20 + 0|; lens 2 is a straight line.
  const Frames frames{picture(8, 1, {0, 0, 10, 0, 50, 60, 70, 80})};
  EXPECT_DOUBLE_EQ(view_flicker(frames, views), (10.0 + 20.0) / 4.0);
}

TEST(LightFigures, view_flicker_of_a_quilt_goes_from_tile_to_tile_and_from_row_to_row) {
  const Optics optics = quilt(2, 2, 1);
  const auto views = neighbouring_views(optics, rows_to_compare(optics, 1));
  ASSERT_EQ(views.size(), 2u);
  // Views 0 and 1 are the lower row, 2 and 3 the upper one: 1 2 4 8 in order.
  const Frames frames{picture(2, 2, {4, 8, 1, 2})};
  EXPECT_DOUBLE_EQ(view_flicker(frames, views), (1.0 + 2.0) / 2.0);
}

TEST(LightFigures, frame_flicker_is_the_second_difference_along_time) {
  const Frames frames{picture(1, 1, {10}), picture(1, 1, {20}), picture(1, 1, {30}), picture(1, 1, {0})};
  EXPECT_DOUBLE_EQ(frame_flicker(frames), (0.0 + 40.0) / 2.0);
}

TEST(LightFigures, flicker_of_two_frames_is_not_a_number) {
  EXPECT_TRUE(std::isnan(frame_flicker({picture(1, 1, {10}), picture(1, 1, {20})})));
}

TEST(LightFigures, compared_rows_are_one_of_every_share) {
  const std::vector<int> rows = rows_to_compare(lenticular(8, 64, 8), 16);
  ASSERT_EQ(rows.size(), 4u);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(rows[static_cast<std::size_t>(k)] / 16, k);
}

TEST(LightFigures, compared_rows_of_a_quilt_are_the_same_in_every_tile) {
  const std::vector<int> rows = rows_to_compare(quilt(2, 3, 32), 16);
  ASSERT_EQ(rows.size(), 6u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(rows[i] + 32, rows[i + 2]);
    EXPECT_EQ(rows[i] + 64, rows[i + 4]);
  }
}

TEST(LightFigures, psnr_at_a_time_between_two_goes_with_the_logarithm) {
  const std::vector<TimedQuality> measured{{4, 4.0, 34.0}, {1, 1.0, 30.0}};
  EXPECT_DOUBLE_EQ(psnr_at_time(measured, 2.0), 32.0);
  EXPECT_DOUBLE_EQ(psnr_at_time(measured, 0.1), 30.0);
  EXPECT_DOUBLE_EQ(psnr_at_time(measured, 9.0), 34.0);
}

}  // namespace
}  // namespace lippmann::bench
