#include "compare/consistency.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/pictures.hpp"

namespace lippmann {
namespace {

using test::smooth_codes;

Image8 grey(int width, int height, unsigned char code) {
  return {width, height, std::vector<unsigned char>(std::size_t{3} * width * height, code)};
}

Image8 row(const std::vector<unsigned char>& codes) {
  Image8 image{static_cast<int>(codes.size()), 1, {}};
  for (const unsigned char code : codes) image.rgb.insert(image.rgb.end(), 3, code);
  return image;
}

TEST(AngularPsnr, error_shared_by_all_views_is_ignored) {
  const std::vector<Image8> a{grey(4, 4, 10), grey(4, 4, 50)}, b{grey(4, 4, 13), grey(4, 4, 53)};
  EXPECT_TRUE(std::isinf(angular_psnr_db(a, b, {2, 1})));
}

TEST(AngularPsnr, alternating_error_is_worked_out_by_hand) {
  const std::vector<Image8> a{grey(4, 4, 10), grey(4, 4, 10), grey(4, 4, 10)}, b{grey(4, 4, 12), grey(4, 4, 9), grey(4, 4, 10)};
  EXPECT_NEAR(angular_psnr_db(a, b, {3, 1}), 10.0 * std::log10(65025.0 / ((9.0 + 1.0) / 2.0)), 1e-12);
}

TEST(AngularPsnr, grid_compares_across_and_up) {
  const std::vector<Image8> a(4, grey(2, 2, 10)), b{grey(2, 2, 11), grey(2, 2, 10), grey(2, 2, 10), grey(2, 2, 10)};
  EXPECT_NEAR(angular_psnr_db(a, b, {2, 2}), 10.0 * std::log10(65025.0 / (2.0 / 4.0)), 1e-12);
}

TEST(AngularPsnr, single_view_gives_nan) { EXPECT_TRUE(std::isnan(angular_psnr_db({grey(4, 4, 1)}, {grey(4, 4, 2)}, {1, 1}))); }

TEST(Flicker, only_the_change_of_error_flickers) {
  const Image8 a = smooth_codes(16, 12);
  Image8 b = a, c = a;
  for (unsigned char& code : b.rgb) code = static_cast<unsigned char>(code < 128 ? code + 6 : code - 6);
  const std::vector<float> motion(2 * 16 * 12, 0.0f);
  EXPECT_EQ(flicker_of(flicker_of_view({a, b, a, b, motion.data()})), 0.0);
  EXPECT_NEAR(flicker_of(flicker_of_view({a, c, a, b, motion.data()})), 6.0, 1e-12);
}

TEST(Flicker, error_moving_with_its_surface_is_ignored) {
  const Image8 before = row({10, 20, 30, 40, 50}), after = row({0, 10, 20, 30, 40});
  const Image8 test_before = row({10, 24, 30, 45, 50}), test_after = row({0, 10, 24, 30, 45});
  const std::vector<float> moved{1, 0, 1, 0, 1, 0, 1, 0, 1, 0}, still(10, 0.0f);
  const FlickerSums sums = flicker_of_view({before, test_before, after, test_after, moved.data()});
  EXPECT_EQ(flicker_of(sums), 0.0);
  EXPECT_EQ(sums.weights, 12.0) << "the first pixel comes from outside of the view";
  EXPECT_GT(flicker_of(flicker_of_view({before, test_before, after, test_after, still.data()})), 1.0);
}

TEST(Flicker, half_pixel_of_motion_mixes_two_pixels) {
  const Image8 flat = grey(3, 1, 100), error = row({100, 100, 108});
  const std::vector<float> motion{0, 0, -0.5f, 0, 0, 0};
  // The previous errors are 0, 0 and 8. Pixel 1 moved by half a pixel, so its previous error is (0 + 8) / 2 = 4. The
  // current frame has no error.
  const FlickerSums sums = flicker_of_view({flat, error, flat, flat, motion.data()});
  EXPECT_NEAR(sums.squares, 3.0 * (16.0 + 64.0), 1e-9);
  EXPECT_EQ(sums.weights, 9.0);
}

TEST(Flicker, disoccluded_points_hardly_count) {
  const Image8 black = grey(4, 4, 0), white = grey(4, 4, 255);
  const std::vector<float> motion(32, 0.0f);
  EXPECT_NEAR(flicker_of_view({black, black, white, black, motion.data()}).weights, 48.0 * std::exp(-150.0), 1e-70);
}

}  // namespace
}  // namespace lippmann
