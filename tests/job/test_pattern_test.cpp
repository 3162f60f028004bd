#include "job/test_pattern.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

constexpr Vec2f kClear{0.6f, 0.63f};

Vec3f pixel_of(const Image& film, int x, int y) { return {film.pixel(x, y)[0], film.pixel(x, y)[1], film.pixel(x, y)[2]}; }

bool is_red(Vec3f c) { return c.x > 4.0f * c.y && c.x > 4.0f * c.z; }
bool is_blue(Vec3f c) { return c.z > 4.0f * c.x && c.z > 4.0f * c.y; }
bool is_grey(Vec3f c) { return c.x == c.y && c.y == c.z && c.x > 0.1f && c.x < 0.5f; }

TEST(TestPattern, zone_goes_from_red_to_blue) {
  EXPECT_TRUE(is_red(test_pattern(kClear, 1.0f, 0.05f)));
  EXPECT_TRUE(is_grey(test_pattern(kClear, 1.0f, 0.5f)));
  EXPECT_TRUE(is_blue(test_pattern(kClear, 1.0f, 0.95f)));
}

TEST(TestPattern, arrows_point_to_the_eye) {
  // The tip of the left arrow, at x = -0.45, is visible only from the left. The tip of the right arrow, at x = 0.45, is visible
  // only from the right.
  const Vec3f white(0.9f);
  EXPECT_EQ(test_pattern({-0.45f, 0.012f}, 1.0f, 0.1f), white);
  EXPECT_NE(test_pattern({0.45f, 0.012f}, 1.0f, 0.1f), white);
  EXPECT_EQ(test_pattern({0.45f, 0.012f}, 1.0f, 0.9f), white);
  EXPECT_NE(test_pattern({-0.45f, 0.012f}, 1.0f, 0.9f), white);
}

TEST(TestPattern, quilt_goes_from_red_to_blue) {
  const ThreadPool pool(2);
  const Image film =
      test_pattern_film({.panel = {500, 100, 0.5f}, .model = MultiView{5, 1, radians(40.0f), false, 300.0f}}, pool);
  // These pixels show the point kClear in tiles 0, 2 and 4 of 100 x 100 pixels. kClear is in units of half a tile's
  // height.
  EXPECT_TRUE(is_red(pixel_of(film, 80, 18)));
  EXPECT_TRUE(is_grey(pixel_of(film, 280, 18)));
  EXPECT_TRUE(is_blue(pixel_of(film, 480, 18)));
}

TEST(TestPattern, lens_pixels_run_from_right_to_left) {
  const ThreadPool pool(1);
  const Image film = test_pattern_film({.panel = {400, 400, 0.125f}, .model = LenticularSheet{}}, pool);
  const int lens = 40 * 8, row = 74;
  EXPECT_TRUE(is_blue(pixel_of(film, lens, row)));
  EXPECT_TRUE(is_red(pixel_of(film, lens + 7, row)));
}

TEST(TestPattern, threads_do_not_change_it) {
  const ThreadPool one(1), three(3);
  const Optics optics{.panel = {30, 40, 0.3f}, .model = SlantedPanel{}};
  EXPECT_EQ(test_pattern_film(optics, one).data, test_pattern_film(optics, three).data);
}

}  // namespace
}  // namespace lippmann
