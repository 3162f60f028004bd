#include "formats/hci_hdf5_cameras.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "lippmann/layout/posed_camera.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using testing::AllOf;
using testing::HasSubstr;

using Attributes = std::map<std::string, double>;

LightField views_with(const Attributes& attributes, ViewGrid grid = {3, 3}) {
  LightField field;
  field.grid = grid, field.view_size = {40, 30};
  EXPECT_TRUE(set_hdf5_cameras(attributes, field, "lf.h5"));
  return field;
}

/// Returns the disparities of a point in pixels. x: how far the point moves to the left from the left view to the middle view.
/// y: how far the point moves down from the lower view to the middle view.
Vec2d disparity_of(const LightField& field, double depth_m) {
  const std::vector<PosedCamera> cameras = posed_cameras(field, "a");
  const Vec3d point = unprojected(cameras[4], {7.0, 11.0}, 1000.0 * depth_m);
  const auto pixel = [&](std::size_t view) { return projected(cameras[view], point); };
  return {pixel(3).x - pixel(4).x, pixel(4).y - pixel(1).y};
}

TEST(HciHdf5Cameras, disparity_is_the_published_formula) {
  const Attributes attributes{{"dH", 0.02}, {"dV", 0.02}, {"focalLength", 700.0}, {"shift", 2.0}};
  const LightField field = views_with(attributes);
  // distance of zero disparity: dH * focalLength / shift = 0.02 * 700 / 2 = 7 m
  EXPECT_DOUBLE_EQ(field.cameras->distance_mm, 7000.0);
  for (const double depth : {3.5, 7.0, 28.0}) {
    const double expected = 0.02 * 700.0 / depth - 2.0;
    EXPECT_NEAR(disparity_of(field, depth).x, expected, 1e-9) << depth;
    EXPECT_NEAR(disparity_of(field, depth).y, expected, 1e-9) << depth;
  }
  EXPECT_NEAR(z_of_hdf5_depth(3.5f, field), 3500.0, 1e-3);
}

TEST(HciHdf5Cameras, views_without_a_common_plane_have_poses) {
  for (const Attributes& attributes : {Attributes{{"dH", 0.02}, {"dV", 0.02}, {"focalLength", 700.0}},
                                       Attributes{{"dH", 0.02}, {"dV", 0.02}, {"focalLength", 700.0}, {"shift", -1.0}},
                                       Attributes{{"dH", 0.02}, {"dV", 0.03}, {"focalLength", 700.0}, {"shift", 2.0}}}) {
    const LightField field = views_with(attributes);
    EXPECT_FALSE(field.cameras);
    const double shift = attributes.contains("shift") ? attributes.at("shift") : 0.0;
    EXPECT_NEAR(disparity_of(field, 5.0).x, 0.02 * 700.0 / 5.0 - shift, 1e-9);
    EXPECT_NEAR(disparity_of(field, 5.0).y, attributes.at("dV") * 700.0 / 5.0 - shift, 1e-9);
    EXPECT_EQ(z_of_hdf5_depth(5.0f, field), -5000.0f);
  }
}

TEST(HciHdf5Cameras, a_single_row_needs_no_vertical_distance) {
  EXPECT_EQ(views_with({{"dH", 0.02}, {"focalLength", 700.0}, {"shift", 2.0}}, {3, 1}).cameras->eyes_mm[0], Vec2d(-20.0, 0.0));
  EXPECT_EQ(views_with({{"dV", 0.02}, {"focalLength", 700.0}, {"shift", 2.0}}, {1, 3}).cameras->eyes_mm[0], Vec2d(0.0, -20.0));
}

TEST(HciHdf5Cameras, missing_attributes_leave_cameras_unknown) {
  LightField field;
  field.grid = {3, 3}, field.view_size = {40, 30};
  EXPECT_FALSE(set_hdf5_cameras({{"dH", 0.02}, {"focalLength", 700.0}}, field, "a"));
  EXPECT_FALSE(set_hdf5_cameras({{"dH", 0.02}, {"dV", 0.02}}, field, "a"));
  EXPECT_FALSE(field.cameras || field.poses);
}

TEST(HciHdf5Cameras, attributes_out_of_range_are_named) {
  LightField field;
  field.grid = {3, 3}, field.view_size = {40, 30};
  const auto refusal = [&](const char* name, double value) {
    Attributes attributes{{"dH", 0.02}, {"dV", 0.02}, {"focalLength", 700.0}, {"shift", 2.0}};
    attributes[name] = value;
    return error_message([&] { set_hdf5_cameras(attributes, field, "lf.h5"); });
  };
  EXPECT_THAT(refusal("dH", 0.0), AllOf(HasSubstr("lf.h5"), HasSubstr("dH is 0")));
  EXPECT_THAT(refusal("dV", -1.0), HasSubstr("dV is -1"));
  EXPECT_THAT(refusal("focalLength", NAN), HasSubstr("focalLength is nan"));
  EXPECT_THAT(refusal("shift", 1e5), HasSubstr("shift is 100000"));
}

TEST(HciHdf5Cameras, nothing_is_there_at_depths_of_no_surface) {
  const LightField field = views_with({{"dH", 0.02}, {"dV", 0.02}, {"focalLength", 700.0}, {"shift", 2.0}});
  for (const float depth : {0.0f, -1.0f, 1e10f, INFINITY, NAN}) EXPECT_EQ(z_of_hdf5_depth(depth, field), -kInfinity) << depth;
}

}  // namespace
}  // namespace lippmann
