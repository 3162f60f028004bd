#include "device/primitives.hpp"

#include <gtest/gtest.h>

#include <random>

#include "lippmann/scene/scene.hpp"

namespace lippmann {
namespace {

LaneRay ray(Vec3f o, Vec3f d, float t_near = 0.0f, float t_far = kInfinity) {
  return {o.x, o.y, o.z, d.x, d.y, d.z, t_near, t_far};
}

const Affine3f kHere;

TEST(SphereDistance, central_rays_hit_front_then_back) {
  const WorldSphere s = to_world(kHere, Sphere{{0, 0, -5}, 1.0f});
  EXPECT_FLOAT_EQ(distance(s, ray({0, 0, 0}, {0, 0, -1})), 4.0f);
  EXPECT_FLOAT_EQ(distance(s, ray({0, 0, 0}, {0, 0, -1}, 4.5f)), 6.0f) << "t_near behind the front";
  EXPECT_EQ(distance(s, ray({0, 0, 0}, {0, 0, -1}, 0.0f, 3.9f)), kInfinity) << "t_far before the front";
  EXPECT_FLOAT_EQ(distance(s, ray({0, 0, -5}, {0, 0, -1})), 1.0f) << "from inside";
  EXPECT_EQ(distance(s, ray({0, 1.001f, 0}, {0, 0, -1})), kInfinity);
}

TEST(SphereDistance, tiny_far_spheres_keep_float_precision) {
  // The centre is 10^4 away, and the radius 10^-2. The formula b^2 - c would lose all digits of the discriminant.
  const WorldSphere s = to_world(kHere, Sphere{{0, 0, -1e4f}, 1e-2f});
  EXPECT_LT(distance(s, ray({0.009f, 0, 0}, {0, 0, -1})), kInfinity);
  EXPECT_EQ(distance(s, ray({0.011f, 0, 0}, {0, 0, -1})), kInfinity);
}

TEST(CylinderDistance, side_is_open_at_both_ends) {
  const WorldCylinder c = to_world(kHere, Cylinder{{0, 0, 0}, {0, 2, 0}, 0.5f});
  EXPECT_FLOAT_EQ(distance(c, ray({0, 1, 3}, {0, 0, -1})), 2.5f);
  EXPECT_FLOAT_EQ(distance(c, ray({0, 1, 0}, {0, 0, -1})), 0.5f) << "from inside";
  EXPECT_EQ(distance(c, ray({0, 2.1f, 3}, {0, 0, -1})), kInfinity);
  EXPECT_EQ(distance(c, ray({0, 5, 0}, {0, -1, 0})), kInfinity) << "along the axis";
  // The ray enters through the open top at 45 degrees, passes over the near wall and hits the far wall.
  const float h = std::sqrt(0.5f);
  EXPECT_NEAR(distance(c, ray({0, 3, 1}, {0, -h, -h})), 1.5f / h, 1e-5f);
}

TEST(RingDistance, hole_lets_rays_through) {
  const WorldRing g = to_world(kHere, Ring{{0, 0, -2}, {0, 0, 1}, 0.5f, 1.0f});
  EXPECT_FLOAT_EQ(distance(g, ray({0.7f, 0, 0}, {0, 0, -1})), 2.0f);
  EXPECT_EQ(distance(g, ray({0.3f, 0, 0}, {0, 0, -1})), kInfinity);
  EXPECT_EQ(distance(g, ray({1.1f, 0, 0}, {0, 0, -1})), kInfinity);
  EXPECT_EQ(distance(g, ray({0.7f, 0, 0}, {1, 0, 0})), kInfinity) << "parallel";
}

TEST(PlaneDistance, both_sides_and_parallel) {
  const WorldPlane p = to_world(kHere, Plane{{0, -1, 0}, {0, 1, 0}});
  EXPECT_FLOAT_EQ(distance(p, ray({0, 0, 0}, {0, -1, 0})), 1.0f);
  EXPECT_FLOAT_EQ(distance(p, ray({0, -3, 0}, {0, 1, 0})), 2.0f);
  EXPECT_EQ(distance(p, ray({0, 0, 0}, {1, 0, 0})), kInfinity);
  EXPECT_EQ(distance(p, ray({0, -1, 0}, {1, 0, 0})), kInfinity) << "in the plane: 0 / 0";
}

TEST(BoxDistance, rotated_box_is_hit_at_its_edge) {
  const Affine3f turned{glm::mat3_cast(glm::angleAxis(radians(45.0f), Vec3f(0, 1, 0))), {0, 0, -5}};
  const WorldBox b = to_world(turned, Box{{-1, -1, -1}, {1, 1, 1}});
  EXPECT_NEAR(distance(b, ray({0, 0, 0}, {0, 0, -1})), 5.0f - std::sqrt(2.0f), 1e-5f);
  EXPECT_NEAR(distance(b, ray({0, 0, -5}, {0, 0, -1})), std::sqrt(2.0f), 1e-5f) << "from inside";
  EXPECT_EQ(distance(b, ray({0, 1.01f, 0}, {0, 0, -1})), kInfinity);
}

TEST(BoxNormal, elongated_box_faces_differ_from_tachyons_rule) {
  const WorldBox b = to_world(kHere, Box{{-10, -1, -1}, {10, 1, 1}});
  const Vec3f on_top(5.0f, 1.0f, 0.0f);
  EXPECT_EQ(glm::normalize(normal_at(b, on_top)), Vec3f(0, 1, 0));
  EXPECT_EQ(tachyon_box_normal(b, on_top), Vec3f(1, 0, 0)) << "|x| is the largest component";
}

template <class F>
float march(const F& f, Vec3f o, Vec3f d, float end) {
  double before = f(glm::dvec3(o));
  constexpr int kSteps = 20000;
  for (int i = 1; i <= kSteps; ++i) {
    const double t = end * i / kSteps;
    const double now = f(glm::dvec3(o) + t * glm::dvec3(d));
    if (before * now < 0) return static_cast<float>(t);
    before = now;
  }
  return kInfinity;
}

TEST(Distances, random_rays_agree_with_marching) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  const auto point = [&] { return Vec3f(uniform(random), uniform(random), uniform(random)); };
  const WorldSphere sphere = to_world(kHere, Sphere{{0.1f, -0.2f, 0.3f}, 0.6f});
  const WorldPlane plane = to_world(kHere, Plane{{0, 0.2f, 0}, glm::normalize(Vec3f(1, 2, 3))});
  int hits = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3f o = 2.0f * point(), d = glm::normalize(point() - o);
    const float expected_sphere =
        march([](glm::dvec3 p) { return glm::length(p - glm::dvec3(0.1, -0.2, 0.3)) - 0.6; }, o, d, 6.0f);
    const float got_sphere = distance(sphere, ray(o, d));
    // march() has steps of 3e-4, so it may miss shorter chords.
    if (expected_sphere < kInfinity) {
      EXPECT_NEAR(got_sphere, expected_sphere, 4e-4f);
    }
    hits += expected_sphere < kInfinity;
    const Vec3f n(plane.nx, plane.ny, plane.nz);
    const float expected_plane = march([&](glm::dvec3 p) { return glm::dot(glm::dvec3(n), p) - plane.offset; }, o, d, 6.0f);
    if (expected_plane < kInfinity) {
      EXPECT_NEAR(distance(plane, ray(o, d)), expected_plane, 4e-4f);
    }
  }
  EXPECT_GT(hits, 30);
}

TEST(Bounds, contain_points_of_the_surface) {
  const Affine3f place{2.0f * glm::mat3_cast(glm::angleAxis(0.8f, glm::normalize(Vec3f(1, 1, 0)))), {1, 2, 3}};
  const WorldCylinder c = to_world(place, Cylinder{{0, 0, 0}, {1, 2, 3}, 0.5f});
  const Bounds3f b = bounds(c);
  const Vec3f axis(c.ax, c.ay, c.az), side = glm::normalize(glm::cross(axis, Vec3f(1, 0, 0))), other = glm::cross(axis, side);
  for (int i = 0; i < 64; ++i) {
    const float a = 2.0f * kPi * static_cast<float>(i) / 64.0f;
    const Vec3f p =
        Vec3f(c.x, c.y, c.z) + c.radius * (std::cos(a) * side + std::sin(a) * other) + (i % 2 ? c.length * axis : Vec3f(0));
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(p[k], b.lower[k] - 1e-5f);
      EXPECT_LE(p[k], b.upper[k] + 1e-5f);
    }
  }
}

}  // namespace
}  // namespace lippmann
