// Folders of miv and cvkit with cameras of any pose.
#include <gmock/gmock.h>

#include <cmath>

#include "formats/cvkit_camera.hpp"
#include "layout/light_fields.hpp"
#include "layout/posed_cameras.hpp"
#include "lippmann/formats/convert.hpp"
#include "lippmann/formats/formats.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::error_message, test::numbered_field, test::same_samples, test::TempDir;
using testing::HasSubstr;

constexpr Vec2i kPictureSize{8, 6};

glm::dmat3 rotation_by(double yaw, double pitch, double roll) {
  const auto turn = [](double degrees, Vec3d axis) { return glm::angleAxis(glm::radians(degrees), axis); };
  return glm::mat3_cast(turn(yaw, {0, 1, 0}) * turn(pitch, {1, 0, 0}) * turn(roll, {0, 0, 1}));
}

LightField posed_views(const std::vector<glm::dmat3>& rotations) {
  LightField field = numbered_field({static_cast<int>(rotations.size()), 1}, kPictureSize);
  field.poses.emplace();
  for (std::size_t view = 0; view < rotations.size(); ++view) {
    const auto i = static_cast<double>(view);
    field.poses->push_back(
        {kPictureSize, {20.0 + i, 20.0 + i}, {4.25, 2.5 + i}, rotations[view], {100.0 - 30.0 * i, 7.0 * i * i, -5.0 * i}});
  }
  field.depth = Image(kPictureSize.x, kPictureSize.y * field.grid.count(), 1);
  for (std::size_t i = 0; i < field.depth->data.size(); ++i)
    field.depth->data[i] = i % 5 == 0 ? -INFINITY : i % 3 ? -400.0f : -800.0f;
  return field;
}

/// The views lie in neither the order of the heights nor from left to right, and the last two look straight down and up.
LightField turned_views() {
  return posed_views({rotation_by(0, 0, 0), rotation_by(35, -20, 10), rotation_by(-170, 50, 100), rotation_by(25, -90, 40),
                      rotation_by(-70, 90, 15)});
}

/// A usual rig: parallel cameras with the same principal point.
LightField parallel_views() {
  LightField field = posed_views(std::vector<glm::dmat3>(3, glm::dmat3(1.0)));
  for (int view = 0; view < 3; ++view)
    (*field.poses)[static_cast<std::size_t>(view)] = {
        kPictureSize, Vec2d(20.0), Vec2d(4.0, 3.0), glm::dmat3(1.0), {50.0 * view, 0.0, 0.0}};
  return field;
}

void expect_same_views(const LightField& back, const LightField& field, const std::string& what) {
  EXPECT_EQ(back.grid, field.grid) << what;
  EXPECT_TRUE(same_samples(back.stack, field.stack)) << what;
  ASSERT_TRUE(back.poses && back.depth && back.poses->size() == field.poses->size()) << what;
  for (std::size_t view = 0; view < field.poses->size(); ++view) {
    const PosedCamera &a = (*field.poses)[view], &b = (*back.poses)[view];
    for (int axis = 0; axis < 3; ++axis) EXPECT_LT(glm::distance(a.rotation[axis], b.rotation[axis]), 1e-6) << what << view;
    EXPECT_LT(glm::distance(a.position_mm, b.position_mm), 1e-6) << what << view;
    EXPECT_LT(glm::distance(a.focal_px, b.focal_px), 1e-6) << what << view;
    EXPECT_LT(glm::distance(a.principal_px, b.principal_px), 1e-6) << what << view;
  }
  for (std::size_t i = 0; i < field.depth->data.size(); ++i)
    if (std::isinf(field.depth->data[i]))
      EXPECT_EQ(back.depth->data[i], -INFINITY) << what << i;
    else
      EXPECT_NEAR(back.depth->data[i] / field.depth->data[i], 1.0, 1e-4) << what << i;
}

TEST(AnyPose, cameras_come_back_along_chains_of_formats) {
  for (const LightField& field : {turned_views(), parallel_views()})
    for (const std::vector<std::string>& chain : std::vector<std::vector<std::string>>{
             {"miv", "miv"}, {"cvkit", "cvkit"}, {"nerf", "miv", "nerf"}, {"miv", "cvkit", "colmap"}}) {
      const TempDir dir;
      find_format(chain[0], "to").write(field, dir / "0", {});
      for (std::size_t i = 1; i < chain.size(); ++i)
        convert(dir / std::to_string(i - 1), dir / std::to_string(i), {.from = chain[i - 1], .to = chain[i]});
      LightField back = find_format(chain.back(), "from").read(dir / std::to_string(chain.size() - 1), {});
      if (chain.back() == "colmap") back.depth = field.depth;  // colmap has no depth maps
      expect_same_views(back, field, chain[0] + chain[1]);
    }
}

/// The camera looks to the right: its axes right, down and forward are the world's backward, down and right.
TEST(AnyPose, rotation_of_cvkit_is_as_worked_by_hand) {
  const std::string text = "camera.A=[20 0 4; 0 20 3; 0 0 1]\ncamera.R=[0 0 1; 0 1 0; -1 0 0]\ncamera.T=[0.1 0.2 0.3]\n";
  const PosedCamera camera = posed_camera(parse_cvkit_camera(text, "a").camera, kPictureSize);
  EXPECT_LT(glm::distance(-camera.rotation[2], Vec3d(1, 0, 0)), 1e-12) << "looks to the right";
  EXPECT_LT(glm::distance(camera.rotation[0], Vec3d(0, 0, 1)), 1e-12) << "its right is backwards";
  EXPECT_LT(glm::distance(camera.position_mm, Vec3d(100, -200, -300)), 1e-9);
  EXPECT_LT(glm::distance(projected(camera, Vec3d(600, -200, -300)), Vec2d(4, 3)), 1e-9) << "a point straight ahead";
}

TEST(AnyPose, matrices_of_cvkit_that_do_not_rotate_are_refused) {
  const auto refusal = [](const std::string& matrix) {
    return error_message(
        [&] { parse_cvkit_camera("camera.A=[20 0 4; 0 20 3; 0 0 1]\ncamera.R=" + matrix + "\n", "a_param.txt"); });
  };
  EXPECT_THAT(refusal("[2 0 0; 0 1 0; 0 0 1]"), HasSubstr("a_param.txt: camera.R: is not a rotation"));
  EXPECT_THAT(refusal("[-1 0 0; 0 1 0; 0 0 1]"), HasSubstr("a_param.txt: camera.R: is left-handed"));
}

}  // namespace
}  // namespace lippmann
