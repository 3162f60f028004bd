#include "lippmann/core/math.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

TEST(Affine3f, inverse_of_a_similarity_undoes_it) {
  const Affine3f a{3.0f * glm::mat3_cast(glm::angleAxis(0.7f, glm::normalize(Vec3f(1, 2, 3)))), {4, 5, 6}};
  const Vec3f p(0.3f, -2.0f, 7.0f);
  const Vec3f q = transform_point(inverse(a), transform_point(a, p));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(q[c], p[c], 1e-5f);
  EXPECT_NEAR(uniform_scale(a), 3.0f, 1e-5f);
}

TEST(Affine3f, product_applies_right_then_left) {
  const Affine3f move{Mat3f(1.0f), {1, 0, 0}}, grow{Mat3f(2.0f), {0, 0, 0}};
  EXPECT_EQ(transform_point(move * grow, {1, 1, 1}), Vec3f(3, 2, 2));
  EXPECT_EQ(transform_point(grow * move, {1, 1, 1}), Vec3f(4, 2, 2));
}

TEST(Bounds3f, empty_box_stays_empty_through_a_transform) {
  EXPECT_TRUE(Bounds3f().empty());
  EXPECT_TRUE(transform_bounds(Affine3f{}, Bounds3f()).empty());
  Bounds3f b;
  b.add(Vec3f(1, 2, 3));
  EXPECT_FALSE(b.empty());
  EXPECT_EQ(b.center(), Vec3f(1, 2, 3));
}

TEST(TransformNormal, uneven_scale_keeps_the_normal_perpendicular) {
  const Affine3f a{Mat3f(4, 0, 0, 0, 1, 0, 0, 0, 1), {}};
  const Vec3f n = transform_normal(a, {1, 1, 0}), tangent = transform_vector(a, {1, -1, 0});
  EXPECT_NEAR(glm::dot(n, tangent), 0.0f, 1e-6f);
}

}  // namespace
}  // namespace lippmann
