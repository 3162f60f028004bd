#include "bench/light_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/image/metrics.hpp"

namespace lippmann::bench {
namespace {

Image8 picture(int width, int height, const std::vector<unsigned char>& greys) {
  Image8 image{width, height, {}};
  for (const unsigned char grey : greys) image.rgb.insert(image.rgb.end(), 3, grey);
  return image;
}

Image8 even(int width, int height, unsigned char grey) {
  return picture(width, height, std::vector<unsigned char>(static_cast<std::size_t>(width) * height, grey));
}

References exact(const Frames& frames) {
  References references;
  for (const Image8& frame : frames) references.push_back({frame, frame});
  return references;
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

TEST(LightFigures, noise_of_references_is_not_counted) {
  // The true value is 100. The references differ from it by (4, -4, 4, -4) and by (6, 6, -6, -6) codes. The products of these
  // differences, (24, -24, -24, 24), add up to 0.
  const References references{{picture(4, 1, {104, 96, 104, 96}), picture(4, 1, {106, 106, 94, 94})}};
  EXPECT_DOUBLE_EQ(mean_squared_error(references, {picture(4, 1, {100, 100, 100, 100})}), 0.0);
  EXPECT_DOUBLE_EQ(mean_squared_error(references, {picture(4, 1, {103, 103, 103, 103})}), 9.0);
}

TEST(LightFigures, light_is_compared_with_the_mean_of_both_halves) {
  // Codes up to 10 are in the linear part of the sRGB curve, so 6 is the mean of 4 and 8 in linear light.
  EXPECT_NEAR(mean_light_ratio({{picture(1, 1, {4}), picture(1, 1, {8})}}, {picture(1, 1, {6})}), 1.0, 1e-12);
}

TEST(LightFigures, blocks_stay_within_views) {
  Image8 stack = even(12, 24, 0);
  for (std::size_t c = 0; c < 3; ++c) {
    stack.rgb[c] = 64;
    stack.rgb[3 * 8 + c] = 255;
    stack.rgb[3 * (8 * 12) + c] = 255;
    stack.rgb[3 * (19 * 12 + 7) + c] = 128;
  }
  const std::vector<double> means = block_means(stack, {12, 12});
  EXPECT_EQ(means, (std::vector<double>{1.0, 1.0, 1.0, 2.0, 2.0, 2.0}));
}

TEST(LightFigures, checkers_of_equal_mean_have_no_block_error) {
  std::vector<unsigned char> checkers;
  for (int i = 0; i < 64; ++i) checkers.push_back((i + i / 8) % 2 == 0 ? 90 : 110);
  const Frames reference{even(8, 8, 100)}, test{picture(8, 8, checkers)};
  EXPECT_DOUBLE_EQ(mean_squared_error(exact(reference), test), 100.0);
  EXPECT_EQ(block_squared_error(exact(reference), test, {8, 8}), 0.0);
}

TEST(LightFigures, offsets_have_equal_block_and_pixel_errors) {
  EXPECT_DOUBLE_EQ(block_squared_error(exact({even(8, 8, 100)}), {even(8, 8, 102)}, {8, 8}), 4.0);
}

TEST(LightFigures, errors_without_blocks_are_nan) {
  EXPECT_TRUE(std::isnan(block_squared_error(exact({even(7, 7, 100)}), {even(7, 7, 102)}, {7, 7})));
}

// Two views of 4 x 1 pixels. The first has an edge between pixels 1 and 2, where the errors are 1 and 3.
TEST(LightFigures, edge_errors_use_both_sides) {
  const Frames reference{picture(4, 2, {0, 0, 16, 16, 100, 100, 100, 100})};
  const Frames test{picture(4, 2, {9, 1, 19, 16, 100, 100, 100, 90})};
  EXPECT_DOUBLE_EQ(edge_squared_error(exact(reference), test, {4, 1}), (1.0 + 9.0) / 2.0);
  EXPECT_TRUE(std::isnan(edge_squared_error(exact({even(4, 2, 5)}), {even(4, 2, 6)}, {4, 1})));
}

// Four views of one pixel, 0, 0, 10, 0: second differences |0 - 2 * 0 + 10| = 10 and |0 - 2 * 10 + 0| = 20.
TEST(LightFigures, view_flicker_is_the_second_difference) {
  EXPECT_DOUBLE_EQ(view_flicker({picture(1, 4, {0, 0, 10, 0})}, {{4, 1}, {1, 1}}), (10.0 + 20.0) / 2.0);
}

TEST(LightFigures, view_flicker_stays_within_rows) {
  const Frames frames{picture(1, 6, {1, 2, 3, 50, 40, 30})};
  EXPECT_DOUBLE_EQ(view_flicker(frames, {{3, 2}, {1, 1}}), 0.0);
  EXPECT_TRUE(std::isnan(view_flicker(frames, {{2, 3}, {1, 1}})));
}

TEST(LightFigures, frame_flicker_is_the_second_difference_along_time) {
  const Frames frames{picture(1, 1, {10}), picture(1, 1, {20}), picture(1, 1, {30}), picture(1, 1, {0})};
  EXPECT_DOUBLE_EQ(frame_flicker(frames), (0.0 + 40.0) / 2.0);
}

TEST(LightFigures, flicker_of_two_frames_is_nan) {
  EXPECT_TRUE(std::isnan(frame_flicker({picture(1, 1, {10}), picture(1, 1, {20})})));
}

}  // namespace
}  // namespace lippmann::bench
