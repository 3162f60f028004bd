#include "scene/builtin/foliage.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh_checks.hpp"

namespace lippmann::builtin {
namespace {

TEST(GrowingTowards, takes_y_to_the_direction) {
  const Vec3f direction = glm::normalize(Vec3f(1, -2, 0.5f));
  for (const float roll : {0.0f, 1.0f, 4.0f})
    EXPECT_LT(glm::length(growing_towards(direction, roll) * Vec3f(0, 1, 0) - direction), 1e-6f);
}

TEST(Leaning, angle_is_measured_from_up) {
  EXPECT_NEAR(leaning(radians(60.0f), 0.7f).y, 0.5f, 1e-6f);
  EXPECT_NEAR(glm::length(leaning(1.1f, 2.0f)), 1.0f, 1e-6f);
}

TEST(BentBranch, starts_upwards_at_the_origin_and_tapers) {
  const Branch branch = bent_branch(2.0f, 0.3f, 0.1f, 0.1f, 10, 1);
  EXPECT_EQ(branch.points.front(), Vec3f(0.0f));
  EXPECT_FLOAT_EQ(branch.points.back().y, 2.0f);
  EXPECT_FLOAT_EQ(branch.radii.front(), 0.3f);
  EXPECT_FLOAT_EQ(branch.radii.back(), 0.1f);
  EXPECT_EQ(branch.point(1.0f), branch.points.back());
  EXPECT_LT(glm::length(branch.point(0.05f) - 0.5f * branch.points[1]), 1e-6f);
}

TEST(GrowSpray, has_two_triangles_per_leaf) {
  const Spray spray = grow_spray(1.0f, 500, 0.05f, 9);
  EXPECT_EQ(spray.leaves.triangles.size(), 1000u);
  for (const Mesh* mesh : {&spray.twigs, &spray.leaves}) {
    EXPECT_EQ(test::count_degenerate(*mesh), 0);
    EXPECT_EQ(test::count_normals_not_unit(*mesh), 0);
    EXPECT_EQ(test::count_facing_wrong(*mesh), 0);
  }
}

TEST(GrowSpray, seed_decides) {
  EXPECT_EQ(grow_spray(1.0f, 50, 0.05f, 9).leaves.positions, grow_spray(1.0f, 50, 0.05f, 9).leaves.positions);
  EXPECT_NE(grow_spray(1.0f, 50, 0.05f, 9).leaves.positions, grow_spray(1.0f, 50, 0.05f, 10).leaves.positions);
}

}  // namespace
}  // namespace lippmann::builtin
