// A quad is a picture of four views in two rows, with the leftmost view at the top left.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formats/quad_name.hpp"
#include "layout/light_fields.hpp"
#include "lippmann/formats/convert.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::numbered_field;
using testing::HasSubstr;

LightField field_of_flat_views(int count) {
  LightField field = numbered_field({count, 1}, {3, 2});
  for (int view = 0; view < count; ++view) {
    Image8 flat{3, 2, std::vector<unsigned char>(18, 0)};
    for (std::size_t i = 0; i < 18; i += 3) flat.rgb[i] = static_cast<unsigned char>(10 * view);
    set_view(field, view, flat);
  }
  return field;
}

TEST(Quad, leftmost_view_is_at_the_top_left) {
  const test::TempDir dir;
  const auto written = find_format("quad", "to").write(field_of_flat_views(4), dir / "a.png", {});
  ASSERT_EQ(written.size(), 1u);
  EXPECT_EQ(written.front().filename(), "a_2x2.png");
  const auto picture = std::get<Image8>(read_picture(written.front()));
  ASSERT_EQ(Vec2i(picture.width, picture.height), Vec2i(6, 4));
  const auto red = [&](std::size_t x, std::size_t y) { return int{picture.rgb[3 * (6 * y + x)]}; };
  EXPECT_EQ(red(0, 0), 0);
  EXPECT_EQ(red(5, 1), 10);
  EXPECT_EQ(red(2, 2), 20);
  EXPECT_EQ(red(3, 3), 30);
}

TEST(Quad, comes_back_by_its_name) {
  const test::TempDir dir;
  const LightField field = numbered_field({4, 1}, {5, 3}, true);
  const auto written = find_format("quad", "to").write(field, dir / "a.png", {});
  const OpenedLightField opened = open_light_field(written.front(), "", {});
  EXPECT_EQ(opened.format, "quad");
  EXPECT_EQ(opened.field.grid, (ViewGrid{4, 1}));
  EXPECT_TRUE(test::same_samples(opened.field.stack, field.stack));
  EXPECT_DOUBLE_EQ(opened.field.aspect, 10.0 / 6.0);
}

TEST(Quad, four_views_of_a_quilt_are_kept) {
  const test::TempDir dir;
  find_format("quilt", "to").write(field_of_flat_views(8), dir / "q.png", {});
  ConvertParams params{.from = "", .to = "quad"};
  const auto convert_quilt = [&] { return convert(dir / "q_qs4x2a1.5.png", dir / "out.png", params); };
  EXPECT_THAT(test::error_message(convert_quilt), HasSubstr("but the light field has 8x1"));
  params.keep = KeptViews{{1, 7, 2}, {}};
  const Converted made = convert_quilt();
  const LightField quad = open_light_field(made.written.front(), "", {}).field;
  for (int view = 0; view < 4; ++view)
    EXPECT_EQ(int{std::get<Image8>(view_of(quad, view)).rgb.front()}, 10 * (2 * view + 1)) << view;
}

TEST(Quad, capitals_and_copies_are_names) {
  for (const char* name : {"a_2x2.png", "A_2X2.PNG", "a_2x2 (1).jpg"}) EXPECT_TRUE(has_quad_name(name)) << name;
  for (const char* name : {"2x2.png", "a_12x2.png", "a_2x2_b.png", "a_2x1.png"}) EXPECT_FALSE(has_quad_name(name)) << name;
  EXPECT_EQ(without_quad_name("b/a_2x2 (1).png"), "b/a (1).png");
  EXPECT_EQ(with_quad_name("b/a.png"), "b/a_2x2.png");
}

}  // namespace
}  // namespace lippmann
