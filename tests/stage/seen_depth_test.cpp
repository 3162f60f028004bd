#include "stage/seen_depth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "room.hpp"

namespace lippmann {
namespace {

/// An eye 300 mm in front of a window of 100 x 100 mm around the origin. A world unit is 1 mm.
constexpr EyeAtWindow kEye{{0.0f, 0.0f, 300.0f}, {100.0f, 100.0f}};

std::optional<SeenDepth> seen(const Scene& scene, const EyeAtWindow& eye = kEye, int threads = 1) {
  return seen_depth(scene, FittedArray{}, 1.0f, eye, ThreadPool(threads));
}

Scene square_at(Vec3f center, float half = 5.0f) {
  Scene scene;
  Mesh square;
  square.positions = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.shapes.emplace_back(std::move(square));
  scene.materials.push_back({"white", MetallicRoughness{}});
  Node node;
  node.local.translation = center;
  scene.nodes.push_back(node);
  Instance shown;
  shown.shape = 0, shown.material = 0, shown.node = 0;
  scene.instances.push_back(shown);
  return scene;
}

TEST(SeenDepth, counts_only_shapes_in_the_window) {
  const auto depth = seen(square_at({0, 0, -40}));
  ASSERT_TRUE(depth);
  EXPECT_FLOAT_EQ(depth->near_mm, -40.0f);
  EXPECT_FLOAT_EQ(depth->far_mm, -40.0f);
  EXPECT_FALSE(seen(square_at({200, 0, -40}))) << "beside the window: at -40 mm it shows 57 mm to each side";
  EXPECT_FALSE(seen(square_at({0, 0, 350}))) << "behind the eye";
  Scene hidden = square_at({0, 0, -40});
  hidden.instances[0].hidden_from_cameras = true;
  EXPECT_FALSE(seen(hidden));
}

TEST(SeenDepth, of_a_room_is_cut_by_the_window) {
  // The room reaches from z = -100 to -300 mm and 100 mm to each side. The view reaches 67 mm to each side at z = -100
  // mm, and 100 mm at z = -300 mm.
  const auto depth = seen(test::room_of_six_walls(100.0f, {0, 0, -200}));
  ASSERT_TRUE(depth);
  EXPECT_NEAR(depth->far_mm, -300.0, 1e-3);
  EXPECT_NEAR(depth->near_mm, -100.0, 1e-3);
  // The eye is inside this room. The view reaches 200 (300 - z) / 300 mm to each side, so the side walls at 100 mm come
  // into view at z = 150 mm.
  EXPECT_NEAR(seen(test::room_of_six_walls(100.0f, {0, 0, 250}), {{0, 0, 300}, {400, 400}})->near_mm, 150.0, 1e-3)
      << "the wall ahead";
  EXPECT_NEAR(seen(test::room_of_six_walls(400.0f), {{0, 0, 300}, {400, 400}})->near_mm, -300.0, 1e-3)
      << "400 mm to each side are reached where 200 (300 - z) / 300 is 400";
}

TEST(SeenDepth, of_off_axis_views_uses_their_eye) {
  // The eye is 150 mm to the right, so the middle of the window shows x = -150 mm at z = -300 mm.
  const Scene scene = square_at({-150, 0, -300}, 1.0f);
  EXPECT_FALSE(seen(scene));
  EXPECT_TRUE(seen(scene, {{150.0f, 0.0f, 300.0f}, {100.0f, 100.0f}}));
}

TEST(SeenDepth, counts_all_frames_with_any_threads) {
  Scene scene = square_at({0, 0, -40});
  scene.timeline.frame_count = 5, scene.timeline.frames_per_second = 1.0;
  NodeAnimation approach;
  approach.node = 0, approach.translation = {{0.0, 4.0}, {Vec3f(0, 0, -40), Vec3f(0, 0, 60)}, Interpolation::kLinear};
  scene.timeline.animations = {approach};
  for (const int threads : {1, 3}) {
    const auto depth = seen(scene, kEye, threads);
    ASSERT_TRUE(depth);
    EXPECT_FLOAT_EQ(depth->near_mm, 60.0f);
    EXPECT_FLOAT_EQ(depth->far_mm, -40.0f);
  }
}

TEST(SeenDepth, of_infinite_planes_reaches_the_horizon) {
  Scene scene = square_at({0, 0, -40});
  scene.shapes[0] = Planes{{Vec3f(0, -20, 40), Vec3f(0, 1, 0)}};  // the plane is 20 mm below the axis
  const auto ground = seen(scene);
  ASSERT_TRUE(ground);
  // The lowest rays fall by 50 mm per 300 mm, and hit the plane 120 mm in front of the eye, at z = 180 mm.
  EXPECT_NEAR(ground->near_mm, 180.0, 1e-3);
  EXPECT_EQ(ground->far_mm, -INFINITY);
  scene.shapes[0] = Planes{{Vec3f(0, 0, 20), Vec3f(0, 0, 1)}};
  EXPECT_NEAR(seen(scene)->near_mm, -20.0, 1e-3);
  EXPECT_NEAR(seen(scene)->far_mm, -20.0, 1e-3);
}

}  // namespace
}  // namespace lippmann
