#include "lippmann/stage/camera_set.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "lippmann/scene/timeline.hpp"
#include "room.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using testing::AllOf;
using testing::HasSubstr;

TEST(CameraSet, text_is_read_and_written) {
  EXPECT_EQ(read_camera_set("hemisphere:12", "cameras"), (CameraSet{CameraPath::kHemisphere, 12}));
  EXPECT_EQ(write_camera_set({CameraPath::kCircle, 7}), "circle:7");
  for (const char* text : {"", "sphere", "sphere:", "sphere:0", "sphere:-1", "sphere:10001", "sphere:5x", "cube:5", ":5"})
    EXPECT_THAT(error_message([&] { read_camera_set(text, "cameras"); }), AllOf(HasSubstr("cameras"), HasSubstr("sphere:N")))
        << text;
}

TEST(CameraSet, sphere_is_covered_evenly) {
  const std::vector<Vec3d> directions = camera_directions({CameraPath::kSphere, 100});
  Vec3d sum(0.0);
  double nearest = INFINITY;
  for (const Vec3d& a : directions) {
    EXPECT_NEAR(glm::length(a), 1.0, 1e-12);
    sum += a;
    for (const Vec3d& b : directions)
      if (&a != &b) nearest = std::min(nearest, glm::distance(a, b));
  }
  EXPECT_LT(glm::length(sum), 1.0) << "of 100";
  EXPECT_GT(nearest, 0.25) << "100 equal circles that cover the sphere have a radius of 0.2";
}

TEST(CameraSet, hemisphere_is_above_and_circle_level) {
  for (const Vec3d& d : camera_directions({CameraPath::kHemisphere, 50})) EXPECT_GT(d.y, 0.0);
  const std::vector<Vec3d> circle = camera_directions({CameraPath::kCircle, 4});
  for (const Vec3d& d : circle) EXPECT_NEAR(d.y, std::sin(glm::radians(20.0)), 1e-12);
  EXPECT_NEAR(circle[1].x, std::cos(glm::radians(20.0)), 1e-12) << "a quarter of the circle later, from the right";
}

TEST(CameraSet, split_follows_seed) {
  const std::vector<bool> split = test_cameras(100, 1);
  EXPECT_EQ(std::count(split.begin(), split.end(), true), 12);
  EXPECT_EQ(split, test_cameras(100, 1));
  EXPECT_NE(split, test_cameras(100, 2));
  EXPECT_EQ(test_cameras(1, 1), std::vector<bool>{false});
  EXPECT_EQ(std::ranges::count(test_cameras(2, 1), true), 1);
}

TEST(CameraSet, cameras_look_at_a_static_scenes_centre) {
  Scene scene = test::room_of_six_walls(1.0f, {3.0f, 0.0f, 0.0f});
  NodeAnimation moves;
  moves.node = 0;
  moves.translation.times = {0.0, 1.0};
  moves.translation.values = {{3, 0, 0}, {9, 9, 9}};
  scene.timeline.animations.push_back(moves);
  scene.timeline.frame_count = 3;
  surround_with_cameras(scene, {CameraPath::kSphere, 20});
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.timeline.frame_count, 20);
  const float distance = scene.cameras[0].focus_distance;
  EXPECT_NEAR(distance, 1.05 * std::sqrt(3.0) / std::sin(glm::radians(22.5)), 1e-4) << "the bounding sphere of the cube";
  const Affine3f wall = evaluate(scene, 0.0).of(0);
  for (int frame = 0; frame < 20; ++frame) {
    const ResolvedScene resolved = evaluate(scene, scene.timeline.time(frame));
    const Affine3f camera = resolved.of(scene.cameras[0].node);
    EXPECT_LT(glm::distance(camera.translation - distance * camera.linear[2], Vec3f(3, 0, 0)), 1e-4f) << frame;
    EXPECT_GT(glm::determinant(camera.linear), 0.0f);
    EXPECT_EQ(resolved.of(0).translation, wall.translation) << frame;
  }
}

TEST(CameraSet, scenes_without_shapes_are_refused) {
  Scene scene;
  EXPECT_THAT(error_message([&] { surround_with_cameras(scene, {}); }), HasSubstr("nothing finite"));
}

}  // namespace
}  // namespace lippmann
