#include "scene/deform.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/scene/load.hpp"

namespace lippmann {
namespace {

/// Tolerance for rounding of floats near 10.
constexpr float kRounding = 1e-5f;

void expect_near(Vec3f actual, Vec3f expected) {
  EXPECT_LE(glm::length(actual - expected), kRounding) << actual.x << " " << actual.y << " " << actual.z;
}

Quatf quarter_about_z() { return {std::sqrt(0.5f), 0, 0, std::sqrt(0.5f)}; }

Scene triangle() {
  Scene scene;
  scene.nodes.resize(1);
  scene.nodes[0].local.translation = {0, 0, 5};
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals.assign(3, Vec3f(0, 0, 1));
  mesh.tangents.assign(3, Vec4f(1, 0, 0, -1));
  mesh.triangles = {{0, 1, 2}};
  scene.shapes = {mesh};
  scene.materials = {{"", MetallicRoughness{}}};
  scene.instances = {{"", 0, 0, 0}};
  return scene;
}

Mesh& mesh_of(Scene& scene) { return std::get<Mesh>(scene.shapes[0]); }

/// The first morph target adds (0, 0, 2) to vertex 1 and (1, 0, 0) to its normal. The second adds (3, 0, 0) to vertex
/// 2. `lift` and `move` are their weights.
Scene morphing(float lift, float move) {
  Scene scene = triangle();
  mesh_of(scene).targets = {{{{0, 0, 0}, {0, 0, 2}, {0, 0, 0}}, {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {}},
                            {{{0, 0, 0}, {0, 0, 0}, {3, 0, 0}}, {}, {}}};
  scene.nodes[0].morph_weights = {lift, move};
  return scene;
}

/// Joint 0 (node 1) translates by (10, 0, 0). Joint 1 (node 2) rotates x to y; its inverse bind matrix translates by
/// (0, 0, 1). Vertices 0 and 1 follow joints 0 and 1, and vertex 2 follows both equally.
Scene skinned() {
  Scene scene = triangle();
  scene.nodes.resize(3);
  scene.nodes[1].local.translation = {10, 0, 0};
  scene.nodes[2].local.rotation = quarter_about_z();
  scene.skins = {{"", {1, 2}, {Affine3f{}, Affine3f{Mat3f(1.0f), {0, 0, 1}}}}};
  mesh_of(scene).skin = {2, {0, 0, 1, 0, 0, 1}, {1, 0, 1, 0, 0.5f, 0.5f}};
  scene.instances[0].skin = 0;
  return scene;
}

PosedVertex vertex_of(const Scene& scene, std::size_t vertex, double time = 0.0) {
  validate(scene, "test");
  const ResolvedScene resolved = evaluate(scene, time);
  return MeshPose(scene, scene.instances[0], resolved).vertex(vertex);
}

TEST(MeshPose, morph_adds_weighted_targets) {
  const Scene scene = morphing(0.5f, 2.0f);
  expect_near(vertex_of(scene, 0).position, {0, 0, 5});
  expect_near(vertex_of(scene, 1).position, {1, 0, 6});
  expect_near(vertex_of(scene, 2).position, {6, 1, 5});
  const float length = std::sqrt(1.25f);
  expect_near(vertex_of(scene, 1).normal, {0.5f / length, 0, 1 / length});
  expect_near(vertex_of(scene, 2).normal, {0, 0, 1});
}

TEST(MeshPose, without_weight_it_is_the_base) { expect_near(vertex_of(morphing(0, 0), 1).position, {1, 0, 5}); }

TEST(MeshPose, skin_follows_joints_only) {
  const Scene scene = skinned();
  expect_near(vertex_of(scene, 0).position, {10, 0, 0});
  expect_near(vertex_of(scene, 1).position, {0, 1, 1});  // (1, 0, 0) + (0, 0, 1) = (1, 0, 1), rotated: (0, 1, 1)
  // Joint 0 moves vertex 2 at (0, 1, 0) to (10, 1, 0), joint 1 to (-1, 0, 1). The result is the mean.
  expect_near(vertex_of(scene, 2).position, {4.5f, 0.5f, 0.5f});
  expect_near(vertex_of(scene, 1).normal, {0, 0, 1});
  expect_near(Vec3f(vertex_of(scene, 1).tangent), {0, 1, 0});
  EXPECT_EQ(vertex_of(scene, 1).tangent.w, -1.0f);
}

TEST(MeshPose, morph_comes_before_the_skin) {
  Scene scene = skinned();
  mesh_of(scene).targets = {{{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {}, {}}};
  scene.nodes[0].morph_weights = {3.0f};
  // The target moves (1, 0, 0) to (4, 0, 0), the inverse bind matrix to (4, 0, 1), the joint to (0, 4, 1).
  expect_near(vertex_of(scene, 1).position, {0, 4, 1});
}

TEST(MeshPose, normals_stay_perpendicular_under_uneven_scale) {
  Scene scene = morphing(0, 0);
  mesh_of(scene).normals[0] = Vec3f(std::sqrt(0.5f), 0, std::sqrt(0.5f));
  scene.nodes[0].local.scale = {2, 1, 1};
  // The scale turns the plane x + z = 0 into x / 2 + z = 0, whose normal is (1/2, 0, 1).
  expect_near(vertex_of(scene, 0).normal, glm::normalize(Vec3f(0.5f, 0, 1)));
}

TEST(MeshPose, flattened_to_nothing_it_keeps_unit_normals) {
  Scene scene = morphing(0, 0);
  scene.nodes[0].local.scale = {0, 0, 0};
  EXPECT_EQ(vertex_of(scene, 0).normal, Vec3f(0, 0, 1));
}

TEST(MeshPose, mirrored_normals_follow_the_order_of_corners) {
  Scene scene = morphing(0, 0);
  scene.nodes[0].local.scale = {-1, 1, 1};
  const ResolvedScene resolved = evaluate(scene, 0.0);
  EXPECT_TRUE(MeshPose(scene, scene.instances[0], resolved).mirrors());
  // After mirroring, (0, 0), (-1, 0), (0, 1) are counter-clockwise as seen from -z.
  expect_near(vertex_of(scene, 0).normal, {0, 0, -1});
}

TEST(MeshPose, clamps_huge_coordinates) {
  Scene scene = skinned();
  scene.nodes[1].local.translation = {3e38f, 3e38f, 0};
  scene.nodes[1].local.scale = Vec3f(3e38f);
  mesh_of(scene).positions[0] = {100, -100, 0};
  EXPECT_EQ(vertex_of(scene, 0).position, Vec3f(MeshPose::kReach, -MeshPose::kReach, 0.0f));
}

NodeAnimation weights(Interpolation interpolation, std::vector<float> values) {
  NodeAnimation animation;
  animation.node = 0;
  animation.morph_weights = {{0.0, 2.0}, std::move(values), interpolation};
  return animation;
}

TEST(MorphWeights, step_and_linear_keys_have_all_weights) {
  Scene scene = morphing(0.25f, 0.75f);
  EXPECT_EQ(evaluate(scene, 1.0).morph_weights.at(0), (std::vector<float>{0.25f, 0.75f}));
  scene.timeline.animations = {weights(Interpolation::kStep, {0, 1, 1, 3})};
  EXPECT_EQ(evaluate(scene, 1.0).morph_weights.at(0), (std::vector<float>{0, 1}));
  scene.timeline.animations[0].morph_weights.interpolation = Interpolation::kLinear;
  EXPECT_EQ(evaluate(scene, 1.0).morph_weights.at(0), (std::vector<float>{0.5f, 2}));
  expect_near(vertex_of(scene, 1, 1.0).position, {1, 0, 6});
}

TEST(MorphWeights, cubic_keys_have_tangents_and_values) {
  Scene scene = morphing(0, 0);
  // Each key lists the in-tangents of both targets, their values, and their out-tangents. The first weight goes from 1
  // (out-tangent 3) to 5 (in-tangent -2) in 2 s. At 0.5 s, the cubic Hermite spline has the value 85/32. All numbers of
  // the second weight are half as large.
  scene.timeline.animations = {weights(Interpolation::kCubicSpline, {9, 9, 1, 0.5f, 3, 1.5f, -2, -1, 5, 2.5f, 9, 9})};
  validate(scene, "test");
  const std::vector<float> at = evaluate(scene, 0.5).morph_weights.at(0);
  EXPECT_NEAR(at[0], 85.0f / 32.0f, kRounding);
  EXPECT_NEAR(at[1], 85.0f / 64.0f, kRounding);
}

TEST(MovingInstances, knows_joints_weights_and_nodes) {
  Scene scene = skinned();
  EXPECT_EQ(moving_instances(scene), std::vector<bool>{false});
  NodeAnimation turn;
  turn.node = 0;
  turn.translation = {{0.0, 1.0}, {{0, 0, 0}, {1, 0, 0}}, Interpolation::kLinear};
  scene.timeline.animations = {turn};
  EXPECT_EQ(moving_instances(scene), std::vector<bool>{false}) << "the node of a skin places nothing";
  scene.timeline.animations[0].node = 2;
  EXPECT_EQ(moving_instances(scene), std::vector<bool>{true});

  Scene morph = morphing(0, 0);
  morph.timeline.animations = {weights(Interpolation::kLinear, {0, 1, 0, 1})};
  EXPECT_EQ(moving_instances(morph), std::vector<bool>{false}) << "the same weights at every key";
  morph.timeline.animations = {weights(Interpolation::kLinear, {0, 1, 0, 2})};
  EXPECT_EQ(moving_instances(morph), std::vector<bool>{true});
  morph.timeline.animations = {turn};
  EXPECT_EQ(moving_instances(morph), std::vector<bool>{true});
}

TEST(FiniteBounds, hold_posed_meshes_where_they_are) {
  const Scene scene = skinned();
  const Bounds3f bounds = finite_bounds(scene, evaluate(scene, 0.0));
  expect_near(bounds.lower, {0, 0, 0});
  expect_near(bounds.upper, {10, 1, 1});
}

}  // namespace
}  // namespace lippmann
