#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "formats/rgbd_name.hpp"
#include "formats/rgbd_side_file.hpp"
#include "layout/light_fields.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message;
using test::numbered_field;
using test::same_samples;
using test::TempDir;
using testing::HasSubstr;

/// Returns 3 views of 4 x 2 pixels on a screen that is 40 mm wide and seen from 100 mm. In view v, column x has the
/// depth -10 x + v mm.
LightField deep_field(bool words = false) {
  LightField field = numbered_field({3, 1}, {4, 2}, words);
  field.cameras = {100.0, Vec2d(10.0), Vec2d(2.0, 1.0), {{-20, 0}, {0, 0}, {20, 0}}};
  field.depth = Image(4, 6, 1);
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 4; ++x) field.depth->pixel(x, y)[0] = static_cast<float>(-10 * x + y / 2);
  return field;
}

TEST(Rgbd, disparity_is_finite_at_any_depth) {
  EXPECT_DOUBLE_EQ(disparity_of_depth(50, 100), 100.0);    // depth / (1 - depth / distance) = 50 / (1 - 50 / 100)
  EXPECT_DOUBLE_EQ(disparity_of_depth(-100, 100), -50.0);  // depth / (1 - depth / distance) = -100 / 2
  EXPECT_DOUBLE_EQ(disparity_of_depth(-INFINITY, 100), -100.0);
  EXPECT_DOUBLE_EQ(depth_of_disparity(-50, 100), -100.0);
  EXPECT_EQ(depth_of_disparity(-100, 100), -INFINITY);
}

TEST(Rgbd, grey_is_linear_in_disparity) {
  const DepthCoding coding{{50, -100}};
  EXPECT_DOUBLE_EQ(grey_of_depth(coding, 100, 50), 1.0);
  EXPECT_DOUBLE_EQ(grey_of_depth(coding, 100, -100), 0.0);
  EXPECT_DOUBLE_EQ(grey_of_depth(coding, 100, 0), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(grey_of_depth(coding, 100, -INFINITY), 0.0);
  EXPECT_DOUBLE_EQ(depth_of_grey(coding, 100, 1.0 / 3.0), 0.0);
  const DepthCoding even{{50, -100}, true, true};
  EXPECT_DOUBLE_EQ(grey_of_depth(even, 100, 0), 1.0 - 2.0 / 3.0) << "in depth, black near";
  EXPECT_NEAR(depth_of_grey(even, 100, 1.0 / 3.0), 0.0, 1e-12);
}

TEST(Rgbd, neighbouring_names_are_read) {
  for (const char* path : {"a/rgbd.png", "a/b.rgbd.png", "a/b_RGBD.png", "a/b_rgbd_copy.png", "a/b-rgbd-1.png"})
    EXPECT_TRUE(has_rgbd_name(path)) << path;
  for (const char* path : {"a/brgbd.png", "a/b_rgbd_.png", "a/rgb.png"}) EXPECT_FALSE(has_rgbd_name(path)) << path;
  EXPECT_EQ(without_rgbd_name("a/rgbd.png"), "a/picture.png");
  EXPECT_TRUE(has_half_rgbd_name("a/b_HRGBD.png"));
  EXPECT_FALSE(has_half_rgbd_name("a/b_RGBD.png"));
  EXPECT_EQ(without_rgbd_name("a/b_HRGBD.png"), "a/b.png");
  EXPECT_EQ(with_rgbd_name("a/b_hrgbd.png"), "a/b_rgbd.png") << "what is written is not squeezed";
  EXPECT_EQ(without_rgbd_name("a/b.rgbd.png"), "a/b.png");
}

TEST(Rgbd, colours_left_and_depth_right) {
  const TempDir dir;
  const LightField field = deep_field();
  const auto written = rgbd_format().write(field, dir / "a.png", {});
  ASSERT_EQ(written.size(), 2u);
  EXPECT_EQ(written[0], dir / "a_rgbd.png");
  const Image8 picture = std::get<Image8>(read_picture(written[0]));
  ASSERT_EQ(size_of(Picture(picture)), Vec2i(8, 2));
  EXPECT_EQ(picture.rgb[0], std::get<Image8>(view_of(field, 1)).rgb[0]);
  EXPECT_EQ(picture.rgb[3 * 4], 255) << "the nearest, at the left";
  EXPECT_EQ(picture.rgb[3 * 7], 0) << "the farthest";
  const auto side = read_rgbd_side_file(written[0]);
  ASSERT_TRUE(side);
  EXPECT_DOUBLE_EQ(side->coding.range.near_mm, 1.0);
  EXPECT_DOUBLE_EQ(side->coding.range.far_mm, -29.0);
  EXPECT_DOUBLE_EQ(side->distance_mm, 100.0);
  EXPECT_EQ(side->size_mm, Vec2d(40, 20));
}

TEST(Rgbd, colours_depth_and_camera_come_back) {
  const TempDir dir;
  const LightField field = deep_field(true);
  const auto path = rgbd_format().write(field, dir / "a.png", {}).front();
  const OpenedLightField opened = open_light_field(path, "", {});
  EXPECT_EQ(opened.format, "rgbd");
  EXPECT_TRUE(same_samples(opened.field.stack, view_of(field, 1)));
  EXPECT_EQ(opened.field.cameras->pixel_mm, Vec2d(10.0));
  // Depths of -29 to 1 mm are disparities of -29 / 1.29 to 1 / 0.99 mm. A step of 16-bit codes is 4e-4 mm in disparity, and
  // less than twice as much in depth.
  for (int x = 0; x < 4; ++x) EXPECT_NEAR(opened.field.depth->pixel(x, 1)[0], -10.0 * x + 1.0, 4e-4) << x;
}

TEST(Rgbd, options_override_the_side_file) {
  const TempDir dir;
  const auto path = rgbd_format().write(deep_field(), dir / "a.png", {}).front();
  FormatOptions options;
  options.depth_range = DepthRange{20, -40};
  const LightField field = rgbd_format().read(path, options);
  EXPECT_NEAR(field.depth->pixel(0, 0)[0], 20.0, 1e-4);
  EXPECT_NEAR(field.depth->pixel(3, 0)[0], -40.0, 1e-4);
}

TEST(Rgbd, assumes_a_range_without_side_file) {
  const TempDir dir;
  fs::copy(rgbd_format().write(deep_field(), dir / "a.png", {}).front(), dir / "b.png");
  const LightField field = rgbd_format().read(dir / "b.png", {});
  EXPECT_NEAR(field.depth->pixel(0, 0)[0], 10.0, 1e-4);
  EXPECT_NEAR(field.depth->pixel(3, 0)[0], -30.0, 1e-4);
  EXPECT_DOUBLE_EQ(field.cameras->pixel_mm.y, 50.0) << "100 mm high";
}

TEST(Rgbd, what_is_no_depth_is_refused) {
  const TempDir dir;
  const auto refused = [&](const Image8& picture) {
    write_picture(dir / "bad.png", picture);
    return error_message([&] { rgbd_format().read(dir / "bad.png", {}); });
  };
  EXPECT_THAT(refused({3, 1, std::vector<unsigned char>(9, 50)}), HasSubstr("3 pixels across"));
  EXPECT_THAT(refused({2, 1, {9, 9, 9, 0, 0, 0}}), HasSubstr("its depth is 0 everywhere"));
  EXPECT_THAT(refused({2, 1, {9, 9, 9, 200, 10, 10}}), HasSubstr("right half has colours"));
  LightField field = deep_field();
  field.depth.reset();
  EXPECT_THAT(error_message([&] { rgbd_format().write(field, dir / "a.png", {}); }), HasSubstr("the views have no depth"));
}

TEST(Rgbd, side_files_that_are_impossible_are_refused) {
  const TempDir dir;
  std::ofstream(dir / "a.png.json") << R"({"rgbd": {"linear_in": "disparity", "white": "near", "near_mm": -5, "far_mm": 5,
    "distance_mm": 100, "size_mm": [40, 20], "eye_mm": [0, 0]}})";
  EXPECT_THAT(error_message([&] { read_rgbd_side_file(dir / "a.png"); }), HasSubstr("far_mm"));
  std::ofstream(dir / "a.png.json") << R"({"rgbd": {"linear_in": "disparity", "white": "near", "near_mm": 5, "far_mm": -5,
    "distance_mm": 100, "size_mm": [40, 20], "eye_mm": [0, 0], "frog": 1}})";
  EXPECT_THAT(error_message([&] { read_rgbd_side_file(dir / "a.png"); }), HasSubstr("frog"));
  std::ofstream(dir / "b.png.json") << R"({"quilt_settings": {}})";
  EXPECT_FALSE(read_rgbd_side_file(dir / "b.png"));
}

}  // namespace
}  // namespace lippmann
