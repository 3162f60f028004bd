#include "lippmann/layout/subset.hpp"

#include <gmock/gmock.h>

#include "layout/light_fields.hpp"
#include "lippmann/core/error.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using test::numbered_field;
using test::same_samples;
using testing::HasSubstr;

LightField with_cameras_and_depth(ViewGrid grid, Vec2i size) {
  LightField field = numbered_field(grid, size);
  field.depth = Image(size.x, size.y * grid.count(), 1);
  for (std::size_t i = 0; i < field.depth->data.size(); ++i) field.depth->data[i] = static_cast<float>(i);
  ViewCameras cameras{500.0, Vec2d(0.5), Vec2d(size) * 0.5};
  for (int view = 0; view < grid.count(); ++view) cameras.eyes_mm.emplace_back(view % grid.columns, view / grid.columns);
  field.cameras = cameras;
  return field;
}

TEST(Keep, step_ranges_keep_depth_and_cameras) {
  const LightField all = with_cameras_and_depth({5, 4}, {2, 3});
  LightField some = all;
  keep(some, read_kept_views("0-4:2x1-2", "--keep"), "--keep");
  EXPECT_EQ(some.grid, (ViewGrid{3, 2}));
  int view = 0;
  for (const int row : {1, 2})
    for (const int column : {0, 2, 4}) {
      EXPECT_TRUE(same_samples(view_of(some, view), view_of(all, 5 * row + column))) << view;
      EXPECT_EQ(depth_of(some, view).data, depth_of(all, 5 * row + column).data) << view;
      EXPECT_EQ(some.cameras->eyes_mm[static_cast<std::size_t>(view)], Vec2d(column, row)) << view;
      ++view;
    }
}

TEST(Keep, accepts_all_and_single_numbers) {
  LightField field = numbered_field({5, 4}, {2, 2});
  keep(field, read_kept_views("allx3", "--keep"), "--keep");
  EXPECT_EQ(field.grid, (ViewGrid{5, 1}));
  keep(field, read_kept_views("4", "--keep"), "--keep");
  EXPECT_EQ(field.grid, (ViewGrid{1, 1}));
  EXPECT_TRUE(same_samples(view_of(field, 0), view_of(numbered_field({5, 4}, {2, 2}), 19)));
}

TEST(Crop, window_moves_the_centre) {
  const LightField all = with_cameras_and_depth({2, 1}, {5, 4});
  LightField field = all;
  crop(field, read_crop("2x3+1+1", "--crop"), "--crop");
  EXPECT_EQ(field.view_size, Vec2i(2, 3));
  EXPECT_EQ(field.cameras->centre_px, Vec2d(1.5, 1.0));
  for (int view = 0; view < 2; ++view)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 2; ++x) {
        const std::size_t to = static_cast<std::size_t>(2 * y + x), from = static_cast<std::size_t>(5 * (y + 1) + x + 1);
        EXPECT_EQ(depth_of(field, view).data[to], depth_of(all, view).data[from]);
        EXPECT_EQ(std::get<Image8>(view_of(field, view)).rgb[3 * to + 2],
                  std::get<Image8>(view_of(all, view)).rgb[3 * from + 2]);
      }
}

TEST(Crop, windows_can_be_combined) {
  LightField twice = numbered_field({2, 2}, {8, 6}), once = twice;
  crop(twice, {{6, 5}, {1, 1}}, "");
  crop(twice, {{2, 2}, {3, 1}}, "");
  crop(once, {{2, 2}, {4, 2}}, "");
  EXPECT_TRUE(same_samples(twice.stack, once.stack));
}

TEST(Subset, rejects_invalid_selections) {
  LightField field = numbered_field({3, 2}, {4, 4});
  for (const char* text : {"", "1x", "2-1x0x", "0-2:0", "-1", "a", "0-2,1"})
    EXPECT_THAT(error_message([&] { read_kept_views(text, "--keep"); }), HasSubstr("as views")) << text;
  for (const char* text : {"", "4x4", "4x4+1", "4x-4+0+0", "4x4+0+0x"})
    EXPECT_THAT(error_message([&] { read_crop(text, "--crop"); }), HasSubstr("as a window")) << text;
  EXPECT_THAT(error_message([&] { keep(field, read_kept_views("0-3", "--keep"), "--keep"); }),
              HasSubstr("columns 0 to 3 are not all among the 3 columns"));
  EXPECT_THAT(error_message([&] { keep(field, read_kept_views("allx2-1", "--keep"), "--keep"); }),
              HasSubstr("rows 2 to 1 are not all among the 2 rows"));
  EXPECT_THAT(error_message([&] { crop(field, read_crop("4x4+1+0", "--crop"), "--crop"); }), HasSubstr("does not lie in"));
  EXPECT_THAT(error_message([&] { crop(field, read_crop("0x4+0+0", "--crop"), "--crop"); }), HasSubstr("does not lie in"));
}

}  // namespace
}  // namespace lippmann
