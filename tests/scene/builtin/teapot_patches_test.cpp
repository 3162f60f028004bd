#include "scene/builtin/teapot_patches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh_checks.hpp"
#include "support/near.hpp"

namespace lippmann::builtin {
namespace {

using test::expect_near;

Mesh teapot(int steps) {
  Mesh mesh;
  for (const BezierPatch& patch : teapot_patches()) tessellate(patch, steps, mesh);
  return mesh;
}

BezierPatch flat_patch() {
  BezierPatch patch;
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      patch[row][column] = {static_cast<float>(column), static_cast<float>(row), 0.0f};
  return patch;
}

TEST(BezierPatch, evenly_spaced_control_points_give_the_plane) {
  expect_near(point_on(flat_patch(), 0.25f, 0.5f), {0.75f, 1.5f, 0});
  expect_near(normal_on(flat_patch(), 0.25f, 0.5f), {0, 0, 1});
}

TEST(BezierPatch, inner_point_has_weight_9_64_squared) {
  // The Bernstein polynomial B1 is 3/8 at 1/2. Lifting one inner control point by 1 lifts the middle by (3/8)^2 = 9/64.
  BezierPatch patch = flat_patch();
  patch[1][1].z = 1.0f;
  expect_near(point_on(patch, 0.5f, 0.5f), {1.5f, 1.5f, 9.0f / 64.0f});
}

TEST(BezierPatch, collapsed_edge_has_the_limit_normal) {
  // If a row of points coincides, the patch is a triangle in the same plane, with the same normal even at the collapsed
  // edge.
  for (const std::size_t row : {std::size_t{0}, std::size_t{3}}) {
    BezierPatch patch = flat_patch();
    for (Vec3f& p : patch[row]) p = {1.5f, static_cast<float>(row), 0.0f};
    for (const float u : {0.0f, 0.3f, 1.0f}) expect_near(normal_on(patch, u, row == 0 ? 0.0f : 1.0f), {0, 0, 1});
  }
  for (const std::size_t column : {std::size_t{0}, std::size_t{3}}) {
    BezierPatch patch = flat_patch();
    for (auto& row : patch) row[column] = {static_cast<float>(column), 1.5f, 0.0f};
    for (const float v : {0.0f, 0.3f, 1.0f}) expect_near(normal_on(patch, column == 0 ? 0.0f : 1.0f, v), {0, 0, 1});
  }
}

TEST(BezierPatch, tessellation_leaves_out_triangles_without_area) {
  BezierPatch patch = flat_patch();
  for (Vec3f& p : patch[0]) p = {1.5f, 0.0f, 0.0f};
  Mesh mesh;
  tessellate(patch, 4, mesh);
  EXPECT_EQ(mesh.positions.size(), 25u);
  EXPECT_EQ(mesh.triangles.size(), 2u * 16u - 4u);
  EXPECT_EQ(test::count_degenerate(mesh), 0);
}

TEST(TeapotPatches, are_newells_thirty_two) { EXPECT_EQ(teapot_patches().size(), 32u); }

TEST(TeapotPatches, corners_are_the_control_points) {
  const std::vector<BezierPatch> patches = teapot_patches();
  expect_near(point_on(patches[0], 0, 0), {1.4f, 0, 2.4f});    // inside of the rim
  expect_near(point_on(patches[4], 1, 1), {0, -2.0f, 0.9f});   // widest circle of the body
  expect_near(point_on(patches[12], 0.5f, 0), {0, 0, 3.15f});  // top of the lid's knob
  expect_near(point_on(patches[20], 0.5f, 1), {0, 0, 0});      // middle of the bottom
}

TEST(TeapotPatches, bounds_are_the_classic_ones) {
  const Mesh mesh = teapot(32);
  Bounds3f b;
  for (const Vec3f& p : mesh.positions) b.add(p);
  EXPECT_NEAR(b.lower.x, -3.0f, 1e-5f);  // bend of the handle, where two patches meet
  EXPECT_NEAR(b.upper.x, 3.434f, 1e-3f);
  EXPECT_NEAR(b.lower.y, -2.0f, 1e-5f);
  EXPECT_NEAR(b.upper.y, 2.0f, 1e-5f);
  EXPECT_NEAR(b.lower.z, 0.0f, 1e-5f);
  EXPECT_NEAR(b.upper.z, 3.15f, 1e-5f);
}

TEST(TeapotPatches, pole_normals_point_up_and_down) {
  const std::vector<BezierPatch> patches = teapot_patches();
  for (const float u : {0.0f, 0.5f, 1.0f}) {
    expect_near(normal_on(patches[12], u, 0), {0, 0, 1}, 1e-4f);
    expect_near(normal_on(patches[20], u, 1), {0, 0, -1}, 1e-4f);
  }
}

TEST(TeapotPatches, mesh_is_sane) {
  const Mesh mesh = teapot(16);
  // 32 patches of 2 * 16^2 triangles. Eight patches have an edge that is a point, where 16 triangles are missing.
  EXPECT_EQ(mesh.triangles.size(), 32u * 2u * 256u - 8u * 16u);
  EXPECT_EQ(test::count_degenerate(mesh), 0);
  EXPECT_EQ(test::count_normals_not_unit(mesh), 0);
  EXPECT_EQ(test::count_facing_wrong(mesh), 0);
}

TEST(TeapotPatches, open_only_where_newell_left_it_open) {
  // The teapot is open between lid (radius 1.3) and rim (1.4) at z = 2.4, where handle and spout meet the body, and at
  // the mouth of the spout.
  int elsewhere = 0;
  for (const test::BoundaryEdge& edge : test::boundary_edges(teapot(8))) {
    const Vec3f p = edge.from;
    const float radius = std::hypot(p.x, p.y);
    // A cubic curve deviates from a quarter of a circle by at most 1.5 % of the radius.
    const bool lid_or_rim = std::abs(p.z - 2.4f) < 1e-4f && radius > 1.28f && radius < 1.42f;
    const bool handle = p.x < -1.4f && p.x > -2.05f && std::abs(p.y) <= 0.3f;
    const bool spout_root = std::abs(p.x - 1.7f) < 1e-4f && std::abs(p.y) <= 0.66f;
    const bool spout_mouth = p.x >= 2.8f - 1e-4f && std::abs(p.z - 2.4f) < 1e-4f && std::abs(p.y) <= 0.15f;
    elsewhere += lid_or_rim || handle || spout_root || spout_mouth ? 0 : 1;
  }
  EXPECT_EQ(elsewhere, 0);
}

TEST(TeapotPatches, is_symmetric_about_its_middle_plane) {
  const Mesh mesh = teapot(6);
  double sum = 0.0;
  for (const Vec3f& p : mesh.positions) sum += static_cast<double>(p.y);
  EXPECT_NEAR(sum / static_cast<double>(mesh.positions.size()), 0.0, 1e-6);
}

}  // namespace
}  // namespace lippmann::builtin
