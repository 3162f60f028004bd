#include "reuse/motion.hpp"

#include <gtest/gtest.h>

#include "reuse/move_points.hpp"
#include "support/near.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using test::SmallScene;

using test::expect_near;

Moment moment_at(const Scene& scene, double time, const Affine3f& world_from_display = {}) {
  return {evaluate(scene, time), world_from_display};
}

TEST(Motion, objects_that_never_move_share_one_group) {
  SmallScene s;
  const int material = s.material(test::glowing(Vec3f(1.0f)));
  s.add(test::square(1, 0), material);
  s.add(test::square(1, 0), material, s.node({Mat3f(1.0f), {1, 2, 3}}));
  const int mover = s.moving_node({0, 0, 0}, {4, 0, 0});
  s.add(test::square(1, 0), material, mover);
  s.add(test::square(1, 0), material, mover);
  const MotionGroups groups = make_motion_groups(s.scene);
  EXPECT_EQ(groups.group_of_object, (std::vector<std::uint32_t>{0, 0, 1, 1}));
  EXPECT_EQ(groups.node_of_group, (std::vector<int>{-1, mover}));
}

TEST(Motion, lights_are_numbered_after_instances) {
  SmallScene s;
  s.add(test::square(1, 0), s.material(test::glowing(Vec3f(1.0f))));
  s.point_light({0, 0, 5}).node = s.moving_node({0, 0, 5}, {1, 0, 5});
  EXPECT_EQ(make_motion_groups(s.scene).group_of_object, (std::vector<std::uint32_t>{0, 1}));
}

TEST(Motion, objects_move_in_display_units) {
  SmallScene s;
  s.add(test::square(1, 0), s.material(test::glowing(Vec3f(1.0f))), s.moving_node({0, 0, 0}, {4, 0, 0}));
  // A millimetre of the display is half a world unit. A quarter turn about z makes the world's x axis the display's -y
  // axis.
  const Affine3f display{0.5f * Mat3f(Vec3f(0, 1, 0), Vec3f(-1, 0, 0), Vec3f(0, 0, 1)), Vec3f(7, 8, 9)};
  const MotionGroups groups = make_motion_groups(s.scene);
  const Motion motion = motion_between(groups, moment_at(s.scene, 0.25, display), moment_at(s.scene, 0.75, display));
  expect_near(moved_point(motion, 0, {10, 20, 30}), {10, 20 - 4, 30}, 1e-5f);  // 2 world units are 4 mm of the display
}

TEST(Motion, moving_display_moves_static_objects_back) {
  SmallScene s;
  s.add(test::square(1, 0), s.material(test::glowing(Vec3f(1.0f))));
  const MotionGroups groups = make_motion_groups(s.scene);
  const Motion motion = motion_between(groups, moment_at(s.scene, 0.0), moment_at(s.scene, 0.0, {Mat3f(1.0f), {1, 2, 3}}));
  EXPECT_TRUE(motion.uniform());
  EXPECT_FALSE(motion.groups[0].still);
  EXPECT_EQ(moved_point(motion, 0, {10, 10, 10}), Vec3f(9, 8, 7));
}

TEST(Motion, objects_back_at_their_start_are_static) {
  SmallScene s;
  s.add(test::square(1, 0), s.material(test::glowing(Vec3f(1.0f))), s.moving_node({0, 0, 0}, {4, 0, 0}));
  const Affine3f display{Mat3f(0.3f), Vec3f(1e4f, 2, 3)};
  const MotionGroups groups = make_motion_groups(s.scene);
  const Moment before = moment_at(s.scene, 2.0, display), after = moment_at(s.scene, 3.0, display);
  const Motion motion = motion_between(groups, before, after);
  EXPECT_TRUE(motion.groups[0].still);
  EXPECT_TRUE(motion.groups[1].still);
  EXPECT_EQ(moved_point(motion, 0, {0.1f, 0.2f, 0.3f}), Vec3f(0.1f, 0.2f, 0.3f));
}

TEST(Motion, distant_worlds_keep_precision) {
  SmallScene s;
  s.add(test::square(1, 0), s.material(test::glowing(Vec3f(1.0f))));
  // The display is 1e5 units from the world's origin, and moves by 1/4 of a unit, which is 1 mm of the display.
  const Affine3f from{Mat3f(0.25f), Vec3f(1e5f, 0, 0)}, to{Mat3f(0.25f), Vec3f(1e5f + 0.25f, 0, 0)};
  const Motion motion = motion_between(make_motion_groups(s.scene), {evaluate(s.scene, 0), from}, {evaluate(s.scene, 0), to});
  EXPECT_EQ(motion.groups[0].rows[3], -1.0f);
}

}  // namespace
}  // namespace lippmann
