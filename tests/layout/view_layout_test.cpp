#include "lippmann/layout/view_layout.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

#include "lippmann/core/error.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {
namespace {

using testing::ElementsAre;

TEST(ViewLayout, pixels_below_a_lens_are_turned_round) {
  // 3 x 2 pixels lie below each lens. The leftmost, lowest eye, of view 0, sees the top right pixel.
  const ViewLayout layout{LayoutKind::kIntegral, {3, 2}, {}};
  EXPECT_THAT(pixels_of_views(layout, {1, 1}, {3, 2}), ElementsAre(2, 1, 0, 5, 4, 3));
}

TEST(ViewLayout, quilt_begins_at_the_bottom_left) {
  const ViewLayout layout{LayoutKind::kQuilt, {4, 1}, {2, 2}};
  EXPECT_THAT(pixels_of_views(layout, {1, 1}, {2, 2}), ElementsAre(2, 3, 0, 1));
}

TEST(ViewLayout, quilt_padding_is_right_and_top) {
  // The tiles leave the top row and the right column of the picture empty.
  const ViewLayout layout{LayoutKind::kQuilt, {2, 1}, {2, 1}};
  EXPECT_EQ(view_size(layout, {5, 3}, "q"), Vec2i(2, 3));
  const ViewLayout tall{LayoutKind::kQuilt, {2, 1}, {1, 2}};
  EXPECT_EQ(view_size(tall, {5, 3}, "q"), Vec2i(5, 1));
  EXPECT_THAT(pixels_of_views(tall, {5, 1}, {5, 3}), ElementsAre(10, 11, 12, 13, 14, 5, 6, 7, 8, 9));
}

TEST(ViewLayout, views_cover_the_picture_once) {
  const ViewLayout layouts[] = {
      {LayoutKind::kIntegral, {5, 3}, {}}, {LayoutKind::kQuilt, {15, 1}, {3, 5}}, {LayoutKind::kStack, {5, 3}, {}}};
  for (const ViewLayout& layout : layouts) {
    const Vec2i picture = picture_size(layout, {4, 7});
    std::vector<std::uint32_t> pixels = pixels_of_views(layout, {4, 7}, picture);
    std::sort(pixels.begin(), pixels.end());
    std::vector<std::uint32_t> all(static_cast<std::size_t>(picture.x * picture.y));
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(pixels, all);
    EXPECT_EQ(view_size(layout, picture, "p"), Vec2i(4, 7));
  }
}

TEST(ViewLayout, rejects_pictures_that_lenses_do_not_fill) {
  try {
    view_size({LayoutKind::kIntegral, {8, 1}, {}}, {510, 4}, "odd.png");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "odd.png");
    EXPECT_THAT(error.problem(), testing::HasSubstr("510x4"));
  }
}

TEST(ViewLayout, lenticular_views_run_left_to_right) {
  Optics optics;
  optics.panel = {24, 4, 0.25f};
  LenticularSheet sheet;
  sheet.lens_pitch_mm = 2.0f, sheet.gap_mm = 4.0f, sheet.offset_mm = 0.0f;
  optics.model = sheet;
  const std::vector<std::uint32_t> pixels = pixels_of_views({LayoutKind::kIntegral, {8, 1}, {}}, {3, 4}, {24, 4});
  float last = -kInfinity;
  for (std::size_t view = 0; view < 8; ++view) {
    const std::uint32_t pixel = pixels[12 * view];
    const Ray ray = ray_of_pixel(optics, {static_cast<float>(pixel % 24) + 0.5f, static_cast<float>(pixel / 24) + 0.5f});
    // A ray from an eye further right runs further left and towards -z, so its x / z is larger.
    const float eye_x = ray.direction.x / ray.direction.z;
    EXPECT_GT(eye_x, last) << "view " << view;
    last = eye_x;
  }
}

}  // namespace
}  // namespace lippmann
