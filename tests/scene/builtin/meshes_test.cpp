#include "scene/builtin/meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh_checks.hpp"

namespace lippmann::builtin {
namespace {

using test::boundary_edges;

void expect_sane(const Mesh& mesh) {
  EXPECT_FALSE(mesh.triangles.empty());
  EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
  EXPECT_EQ(test::count_degenerate(mesh), 0);
  EXPECT_EQ(test::count_normals_not_unit(mesh), 0);
  EXPECT_EQ(test::count_facing_wrong(mesh), 0);
}

TEST(Lathe, cylinder_has_outward_radial_normals) {
  const Mesh mesh = lathe({{2.0f, 0.0f}, {2.0f, 3.0f}}, 16);
  expect_sane(mesh);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3f radial(mesh.positions[i].x / 2.0f, 0.0f, mesh.positions[i].z / 2.0f);
    EXPECT_LT(glm::length(mesh.normals[i] - radial), 1e-6f);
  }
}

TEST(Lathe, repeated_point_is_a_crease) {
  const Mesh mesh = cone(1.0f, 1.0f, 8);
  bool down = false, slanted = false;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (std::hypot(mesh.positions[i].x, mesh.positions[i].z) < 0.5f) continue;
    down |= mesh.normals[i].y < -0.999f;
    slanted |= std::abs(mesh.normals[i].y - std::sqrt(0.5f)) < 1e-5f;  // a slope of 45 degrees
  }
  EXPECT_TRUE(down && slanted);
}

TEST(Cone, is_closed_and_has_its_volume) {
  const Mesh mesh = cone(1.0f, 3.0f, 64);
  expect_sane(mesh);
  EXPECT_TRUE(boundary_edges(mesh).empty());
  // The volume is height / 3 * base area. The height is 3, and the base, with 64 corners, has the area 32 * sin(2 pi /
  // 64).
  EXPECT_NEAR(test::signed_volume(mesh), 32.0 * std::sin(2.0 * M_PI / 64.0), 1e-4);
}

TEST(UvSphere, is_closed_with_exact_normals) {
  const Mesh mesh = uv_sphere(2.0f, 24, 12);
  expect_sane(mesh);
  EXPECT_TRUE(boundary_edges(mesh).empty());
  EXPECT_EQ(mesh.triangles.size(), 24u * (12u * 2u - 2u));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    EXPECT_LT(glm::length(2.0f * mesh.normals[i] - mesh.positions[i]), 1e-5f);
}

TEST(Torus, is_closed_with_exact_normals) {
  const Mesh mesh = torus(3.0f, 1.0f, 48, 24);
  expect_sane(mesh);
  EXPECT_TRUE(boundary_edges(mesh).empty());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3f& p = mesh.positions[i];
    const Vec3f ring_point = 3.0f * glm::normalize(Vec3f(p.x, 0.0f, p.z));
    EXPECT_LT(glm::length(mesh.normals[i] - (p - ring_point)), 1e-5f);
  }
}

TEST(Tube, closed_curve_closes_despite_twist) {
  std::vector<Vec3f> trefoil;
  for (int i = 0; i < 120; ++i) {
    const float t = 2.0f * kPi * static_cast<float>(i) / 120.0f;
    trefoil.push_back({std::sin(t) + 2.0f * std::sin(2.0f * t), std::cos(t) - 2.0f * std::cos(2.0f * t), -std::sin(3.0f * t)});
  }
  const Mesh mesh = tube(trefoil, std::vector<float>(trefoil.size(), 0.3f), 12, true);
  expect_sane(mesh);
  EXPECT_TRUE(boundary_edges(mesh).empty());
  EXPECT_GT(test::signed_volume(mesh), 0.0);
}

TEST(Tube, open_tube_has_two_open_ends) {
  const Mesh mesh = tube({{0, 0, 0}, {0, 1, 0}, {0, 2, 0.5f}}, {0.2f, 0.2f, 0.1f}, 8, false);
  expect_sane(mesh);
  EXPECT_EQ(boundary_edges(mesh).size(), 16u);
}

TEST(Disc, faces_up_with_planar_uvs) {
  const Mesh mesh = disc(2.0f, 32, 4.0f);
  expect_sane(mesh);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_GT(mesh.normals[i].y, 0.999f);
    EXPECT_FLOAT_EQ(mesh.uvs[i].x, mesh.positions[i].x / 4.0f);
  }
}

TEST(Rectangle, texture_stands_upright) {
  const Mesh mesh = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 3});
  expect_sane(mesh);
  EXPECT_EQ(mesh.normals[0], Vec3f(0, 0, 1));
  EXPECT_EQ(mesh.uvs[3], Vec2f(0, 0));  // uv (0, 0) is the top left of the texture
  EXPECT_EQ(mesh.positions[3], Vec3f(-1, 1, 0));
}

TEST(SmoothProfile, passes_through_its_points_and_keeps_creases) {
  const std::vector<Vec2f> profile = smooth_profile({{0, 0}, {1, 0}, {1, 0}, {2, 1}, {2, 3}}, 4);
  EXPECT_EQ(profile.size(), 4u + 1u + 4u + 4u + 1u);
  EXPECT_EQ(profile[4], Vec2f(1, 0));
  EXPECT_EQ(profile[5], Vec2f(1, 0));
  EXPECT_EQ(profile[9], Vec2f(2, 1));
  EXPECT_EQ(profile.back(), Vec2f(2, 3));
}

Mesh welded_cube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.push_back({i & 1 ? 1 : 0, i & 2 ? 1 : 0, i & 4 ? 1 : 0});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TEST(WithCreases, cube_gets_three_normals_at_every_corner) {
  const Mesh mesh = with_creases(welded_cube(), radians(30.0f));
  expect_sane(mesh);
  EXPECT_EQ(mesh.positions.size(), 24u);
  for (const Vec3f& n : mesh.normals) EXPECT_NEAR(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), 1.0f, 1e-6f);
}

TEST(WithCreases, wide_angle_smooths_everything) {
  const Mesh mesh = with_creases(welded_cube(), radians(120.0f));
  expect_sane(mesh);
  EXPECT_EQ(mesh.positions.size(), 8u);
}

TEST(Append, moves_points_and_turns_normals) {
  Mesh mesh;
  append(mesh, disc(1.0f, 8, 1.0f));
  const Affine3f turn{glm::mat3_cast(glm::angleAxis(radians(90.0f), Vec3f(0, 0, 1))), {5, 0, 0}};
  append(mesh, disc(1.0f, 8, 1.0f), turn);
  expect_sane(mesh);
  EXPECT_LT(mesh.normals.back().x, -0.999f);
  EXPECT_NEAR(mesh.positions.back().x, 5.0f, 1e-6f);
}

}  // namespace
}  // namespace lippmann::builtin
