#include "align/warp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/pictures.hpp"

namespace lippmann::test {
namespace {

TEST(Similarity, inverse_and_product_agree) {
  const Similarity first{0.9, 0.2, 3.0, -4.0}, second{1.1, -0.3, 7.0, 5.0};
  const Vec2d place(12.0, -8.0), moved = second(first(place));
  EXPECT_NEAR(glm::length((second * first)(place)-moved), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(inverse(first)(first(place)) - place), 0.0, 1e-12);
  EXPECT_NEAR((Similarity{0.0, 2.0, 0.0, 0.0}).turn_deg(), 90.0, 1e-12) << "x maps to y, which points down: clockwise";
}

TEST(Warp, whole_pixels_keep_their_values) {
  const Image picture = noise_image(20, 14, 3);
  const ThreadPool pool(1);
  const Image moved = warped(picture, {1.0, 0.0, 3.0, -2.0}, {5, 1}, {10, 8}, pool);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 10; ++x)
      for (int c = 0; c < 3; ++c) ASSERT_EQ(moved.pixel(x, y)[c], picture.pixel(x + 5 - 3, y + 1 + 2)[c]) << x << " " << y;
}

TEST(Warp, waves_move_by_subpixels_and_rotate) {
  Image picture(64, 64, 3);
  const auto wave = [](Vec2d place) {
    return static_cast<float>(0.5 + 0.3 * std::sin(0.4 * place.x) * std::cos(0.3 * place.y));
  };
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) std::fill_n(picture.pixel(x, y), 3, wave(Vec2d(x, y) + 0.5));
  const Similarity moved{1.02 * std::cos(0.05), 1.02 * std::sin(0.05), 0.37, -1.61};
  const ThreadPool pool(2);
  const Image result = warped(picture, moved, {16, 16}, {32, 32}, pool);
  for (int y = 0; y < 32; ++y)
    // A Lanczos filter of three lobes changes a wave with a period of 15 pixels by at most 1 %.
    for (int x = 0; x < 32; ++x)
      ASSERT_NEAR(result.pixel(x, y)[1], wave(inverse(moved)(Vec2d(x + 16.5, y + 16.5))), 0.004) << x << " " << y;
}

}  // namespace
}  // namespace lippmann::test
