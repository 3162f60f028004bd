// The figures of path-traced light, on pictures of a few pixels.
#include "bench/light_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "bench/light_pictures.hpp"
#include "lippmann/image/metrics.hpp"

namespace lippmann::bench {
namespace {

/// Grey pixels.
Image8 picture(int width, int height, const std::vector<unsigned char>& greys) {
  Image8 image{width, height, {}};
  for (const unsigned char grey : greys) image.rgb.insert(image.rgb.end(), 3, grey);
  return image;
}

/// Frames without noise: both halves are the same.
References exact(const Frames& frames) {
  References references;
  for (const Image8& frame : frames) references.push_back({frame, frame});
  return references;
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
  EXPECT_TRUE(std::isinf(psnr_db(mean_squared_error(exact(frames), frames))));
}

TEST(LightFigures, error_is_the_mean_over_all_frames) {
  const Frames reference{picture(2, 1, {10, 20}), picture(2, 1, {30, 40})};
  const Frames test{picture(2, 1, {12, 20}), picture(2, 1, {30, 44})};
  EXPECT_DOUBLE_EQ(mean_squared_error(exact(reference), test), (4.0 + 16.0) / 4.0);
}

TEST(LightFigures, noise_of_references_is_no_error_of_the_test) {
  // The halves err by 4 and by 6: a test that is right differs from both, but its products vanish on average.
  const References references{{picture(4, 1, {104, 96, 104, 96}), picture(4, 1, {106, 106, 94, 94})}};
  EXPECT_DOUBLE_EQ(mean_squared_error(references, {picture(4, 1, {100, 100, 100, 100})}), 0.0);
  EXPECT_DOUBLE_EQ(mean_squared_error(references, {picture(4, 1, {103, 103, 103, 103})}), 9.0);
}

TEST(LightFigures, light_is_held_against_the_mean_of_both_halves) {
  // Codes up to 10 are in the straight part of the sRGB curve.
  EXPECT_NEAR(mean_light_ratio({{picture(1, 1, {4}), picture(1, 1, {8})}}, {picture(1, 1, {6})}), 1.0, 1e-12);
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

TEST(LightFigures, compared_rows_are_one_band_of_every_share) {
  const std::vector<int> rows = rows_to_compare(lenticular(8, 512, 8), 16);
  ASSERT_EQ(rows.size(), 4u * kBlockSide);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i] / 128, static_cast<int>(i) / kBlockSide);
    EXPECT_EQ(rows[i], rows[i / kBlockSide * kBlockSide] + static_cast<int>(i) % kBlockSide);
  }
}

TEST(LightFigures, compared_rows_of_a_share_of_one_are_all) {
  const std::vector<int> rows = rows_to_compare(quilt(2, 2, 20), 1);
  ASSERT_EQ(rows.size(), 40u);
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i], static_cast<int>(i));
}

TEST(LightFigures, compared_rows_of_a_picture_lower_than_its_share_are_one_band) {
  EXPECT_EQ(rows_to_compare(lenticular(8, 64, 8), 32).size(), 8u);
}

TEST(LightFigures, compared_rows_of_a_quilt_are_the_same_in_every_tile) {
  const std::vector<int> rows = rows_to_compare(quilt(2, 3, 64), 4);
  ASSERT_EQ(rows.size(), 3u * 2u * kBlockSide);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(rows[i] + 64, rows[i + 16]);
    EXPECT_EQ(rows[i] + 128, rows[i + 32]);
  }
}

TEST(LightFigures, block_below_lenses_is_of_one_view_and_neighbouring_lenses) {
  const Optics optics = lenticular(64, 8, 4);  // 16 lenses: two blocks of each of four views
  const std::vector<Block> blocks = view_blocks(optics, rows_to_compare(optics, 1));
  ASSERT_EQ(blocks.size(), 8u);
  for (std::size_t b = 0; b < 8; ++b)
    for (std::size_t i = 0; i < 64; ++i)
      EXPECT_EQ(blocks[b][i], i / 8 * 64 + b / 4 * 32 + i % 8 * 4 + b % 4) << "block " << b << ", pixel " << i;
}

TEST(LightFigures, blocks_of_a_quilt_stay_within_tiles_and_leave_out_their_edges) {
  const Optics optics = quilt(2, 2, 12);
  const std::vector<Block> blocks = view_blocks(optics, rows_to_compare(optics, 1));
  ASSERT_EQ(blocks.size(), 4u);  // one of each tile, from its upper left corner
  const std::uint32_t corners[] = {0, 12, 12 * 24, 12 * 24 + 12};
  for (std::size_t b = 0; b < 4; ++b)
    for (std::size_t i = 0; i < 64; ++i) EXPECT_EQ(blocks[b][i], corners[b] + i / 8 * 24 + i % 8) << b << ", " << i;
}

TEST(LightFigures, every_band_has_blocks_of_its_own) {
  const Optics optics = lenticular(8, 512, 1);
  const std::vector<int> rows = rows_to_compare(optics, 16);
  const std::vector<Block> blocks = view_blocks(optics, rows);
  ASSERT_EQ(blocks.size(), 4u);
  for (std::size_t b = 0; b < 4; ++b) EXPECT_EQ(blocks[b].front(), 64 * b);
}

TEST(LightFigures, checkers_of_equal_mean_are_an_error_of_pixels_alone) {
  const Optics optics = quilt(1, 1, 8);
  const std::vector<Block> blocks = view_blocks(optics, rows_to_compare(optics, 1));
  std::vector<unsigned char> checkers;
  for (int i = 0; i < 64; ++i) checkers.push_back((i + i / 8) % 2 == 0 ? 90 : 110);
  const Frames reference{picture(8, 8, std::vector<unsigned char>(64, 100))}, test{picture(8, 8, checkers)};
  EXPECT_DOUBLE_EQ(mean_squared_error(exact(reference), test), 100.0);  // 28.1 dB
  EXPECT_EQ(block_squared_error(exact(reference), test, blocks), 0.0);
  EXPECT_TRUE(std::isinf(psnr_db(block_squared_error(exact(reference), test, blocks))));
}

TEST(LightFigures, offset_of_two_codes_is_an_error_of_blocks_as_of_pixels) {
  const Optics optics = quilt(1, 1, 8);
  const std::vector<Block> blocks = view_blocks(optics, rows_to_compare(optics, 1));
  const Frames reference{picture(8, 8, std::vector<unsigned char>(64, 100))},
      test{picture(8, 8, std::vector<unsigned char>(64, 102))};
  EXPECT_DOUBLE_EQ(block_squared_error(exact(reference), test, blocks), 4.0);
  EXPECT_NEAR(psnr_db(block_squared_error(exact(reference), test, blocks)), 42.110, 1e-3);  // 10 log10(255^2 / 4)
}

TEST(LightFigures, block_error_is_not_a_number_without_blocks) {
  const Frames frames{picture(2, 1, {10, 20})};
  EXPECT_TRUE(std::isnan(block_squared_error(exact(frames), frames, {})));
}

// Of 144 blocks one is wrong by 12 codes; the worst hundredth is this one.
TEST(LightFigures, worst_blocks_show_what_all_of_them_hide) {
  const Optics optics = quilt(1, 1, 96);
  const std::vector<Block> blocks = view_blocks(optics, rows_to_compare(optics, 1));
  const Frames reference{picture(96, 96, std::vector<unsigned char>(96 * 96, 100))};
  Frames test = reference;
  for (const std::uint32_t pixel : blocks[5])
    for (std::uint32_t c = 0; c < 3; ++c) test[0].rgb[3 * pixel + c] = 112;
  EXPECT_DOUBLE_EQ(worst_block_squared_error(exact(reference), test, blocks), 144.0);
  EXPECT_DOUBLE_EQ(block_squared_error(exact(reference), test, blocks), 1.0);
  EXPECT_TRUE(std::isnan(worst_block_squared_error(exact(reference), test, {})));
}

// A step of 20 codes between the third and the fourth column: 16 pixels are at it, and one of them is wrong by 8.
TEST(LightFigures, pixels_at_edges_are_those_beside_a_step) {
  const Optics optics = quilt(1, 1, 8);
  const std::vector<Block> blocks = view_blocks(optics, rows_to_compare(optics, 1));
  std::vector<unsigned char> step;
  for (int i = 0; i < 64; ++i) step.push_back(i % 8 < 3 ? 100 : 120);
  const Frames reference{picture(8, 8, step)};
  step[2] = 108;  // at the edge
  step[7] = 128;  // far from it
  EXPECT_DOUBLE_EQ(edge_squared_error(exact(reference), {picture(8, 8, step)}, blocks), 64.0 / 16.0);
  const Frames even{picture(8, 8, std::vector<unsigned char>(64, 100))};
  EXPECT_TRUE(std::isnan(edge_squared_error(exact(even), even, blocks)));
}

TEST(LightFigures, mean_light_is_linear_in_light) {
  // Codes up to 10 are in the straight part of the sRGB curve.
  EXPECT_NEAR(mean_light_ratio(exact({picture(2, 1, {10, 10})}), {picture(2, 1, {5, 10})}), 0.75, 1e-12);
  // 188 shows half the light of 255: ((188 / 255 + 0.055) / 1.055)^2.4 = 0.5029.
  EXPECT_NEAR(mean_light_ratio(exact({picture(1, 1, {255})}), {picture(1, 1, {188})}), 0.5029, 5e-5);
}

TEST(LightFigures, error_pictures_show_differences_around_mid_grey) {
  const Image8 reference = picture(3, 1, {100, 100, 0}), test = picture(3, 1, {100, 97, 255});
  const Image8 error = error_picture(reference, test);
  EXPECT_EQ(error.rgb[0], 128);
  EXPECT_EQ(error.rgb[3], 128 - 3 * 8);
  EXPECT_EQ(error.rgb[6], 255);
}

TEST(LightFigures, block_error_picture_fills_blocks_with_the_difference_of_their_means) {
  const Optics optics = quilt(1, 1, 9);
  const std::vector<Block> blocks = view_blocks(optics, rows_to_compare(optics, 1));
  const Image8 reference = picture(9, 9, std::vector<unsigned char>(81, 100));
  Image8 test = reference;
  for (std::size_t c = 0; c < 3; ++c) test.rgb[c] = 132;  // one pixel of 64 differs by 32: half a code of the mean
  const Image8 error = block_error_picture(reference, test, blocks);
  EXPECT_EQ(error.rgb[0], 128 + 4);
  EXPECT_EQ(error.rgb[3 * 7], 128 + 4);
  EXPECT_EQ(error.rgb[3 * 8], 128);
}

TEST(LightFigures, estimates_are_held_against_frames_that_have_one_and_differ) {
  const EstimateFigures figures =
      judge_estimates({40.0, std::nullopt, 36.0, 50.0}, {34.0, 30.0, 38.0, std::numeric_limits<double>::infinity()});
  EXPECT_DOUBLE_EQ(figures.mean_db, 38.0);
  EXPECT_DOUBLE_EQ(figures.mean_excess_db, 2.0);  // 6 too much, 2 too little
  EXPECT_DOUBLE_EQ(figures.largest_error_db, 6.0);
  EXPECT_EQ(figures.frames, 2);
  EXPECT_EQ(figures.close, 0);
  EXPECT_EQ(judge_estimates({40.0, 36.0}, {40.5, 36.6}).close, 1);
  EXPECT_TRUE(std::isnan(judge_estimates({std::nullopt}, {30.0}).mean_db));
}

TEST(LightFigures, psnr_at_a_time_between_two_goes_with_the_logarithm) {
  const std::vector<TimedQuality> measured{{4, 4.0, 34.0}, {1, 1.0, 30.0}};
  EXPECT_DOUBLE_EQ(psnr_at_time(measured, 2.0), 32.0);
  EXPECT_DOUBLE_EQ(psnr_at_time(measured, 0.1), 30.0);
  EXPECT_DOUBLE_EQ(psnr_at_time(measured, 9.0), 34.0);
}

}  // namespace
}  // namespace lippmann::bench
