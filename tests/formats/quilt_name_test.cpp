#include "lippmann/formats/quilt_name.hpp"

#include <gtest/gtest.h>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

TEST(QuiltName, says_tiles_and_aspect) {
  const auto name = parse_quilt_name("a/room_qs8x6a0.75.png");
  ASSERT_TRUE(name);
  EXPECT_EQ(name->tiles, (ViewGrid{8, 6}));
  EXPECT_EQ(name->aspect, 0.75);
}

TEST(QuiltName, ignores_zoom_and_focus) {
  const auto name = parse_quilt_name("x_qs5x9a1.77778z1.2f-0.3.jpg");
  ASSERT_TRUE(name);
  EXPECT_EQ(name->tiles, (ViewGrid{5, 9}));
  EXPECT_EQ(name->aspect, 1.77778);
}

TEST(QuiltName, copies_and_capitals_are_read) {
  for (const char* path :
       {"a/b_qs8x6a0.75 (1).png", "a/b_qs8x6a0.75(12).png", "a/b_QS8X6A0.75.PNG", "a/b_qs8x6a0.75 - Copy.png",
        "a/b_qs8x6a.75 - Kopie (2).png", "a/b_qs8x6a0.75 copy 2.png", "a/b_qs8x6a0.75z1f0 3.jpg"}) {
    const auto name = parse_quilt_name(path);
    ASSERT_TRUE(name) << path;
    EXPECT_EQ(name->tiles, (ViewGrid{8, 6})) << path;
    EXPECT_EQ(name->aspect, 0.75) << path;
  }
  EXPECT_EQ(without_quilt_name("a/b_qs8x6a0.75 (1).png"), "a/b (1).png");
}

TEST(QuiltName, neighbouring_forms_are_read) {
  for (const char* path :
       {"a/qs8x6a0.75.png", "a/b-qs8x6a0.75.png", "a/b qs8x6a0.75.png", "a/b.qs8x6a0.75.png", "a/b_qs8x6a0.75_copy.png",
        "a/b_qs8x6a0.75-1.png", "a/b_qs8x6a0.75.png.png", "a/b_qs8x6a0.75f30.png.jpg"}) {
    const auto name = parse_quilt_name(path);
    ASSERT_TRUE(name) << path;
    EXPECT_EQ(name->tiles, (ViewGrid{8, 6})) << path;
    EXPECT_EQ(name->aspect, 0.75) << path;
  }
  EXPECT_FALSE(parse_quilt_name("b-qs8x6a75.png"));
  EXPECT_EQ(without_quilt_name("a/qs8x6a0.75.png"), "a/quilt.png");
  EXPECT_EQ(without_quilt_name("a/b_qs8x6a0.75.png.png"), "a/b.png");
  EXPECT_EQ(with_quilt_name("a/_qs8x6a0.75.png", {{5, 9}, 1.5}), "a/quilt_qs5x9a1.5.png");
}

TEST(QuiltName, tiles_are_found_without_aspect) {
  EXPECT_EQ(tiles_in_name("a_qs8x6a0,75.png"), (ViewGrid{8, 6}));
  EXPECT_EQ(tiles_in_name("room_qs8x6.png"), (ViewGrid{8, 6}));
  EXPECT_FALSE(tiles_in_name("a_qs0x6.png"));
  EXPECT_FALSE(tiles_in_name("room.png"));
}

TEST(QuiltName, other_names_say_nothing) {
  for (const char* path : {"room.png", "qs8x6.png", "room_qs8x6.png", "room_qs8x6a0.75_v2.png"})
    EXPECT_FALSE(parse_quilt_name(path)) << path;
}

TEST(QuiltName, impossible_quilts_are_refused) {
  for (const char* path : {"a_qs0x6a0.75.png", "a_qs8x0a1.png", "a_qs8x6a0.png"})
    EXPECT_THROW(parse_quilt_name(path), Error) << path;
}

TEST(QuiltName, is_put_before_the_ending_and_replaced) {
  const QuiltName name{{11, 6}, 0.5625};
  EXPECT_EQ(with_quilt_name("out/b.png", name), "out/b_qs11x6a0.5625.png");
  EXPECT_EQ(with_quilt_name("out/b_qs8x6a0.75.png", name), "out/b_qs11x6a0.5625.png");
}

}  // namespace
}  // namespace lippmann
