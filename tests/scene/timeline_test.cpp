#include "lippmann/scene/timeline.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

// Tolerance for rounding of floats near 1.
constexpr float kRounding = 2e-6f;

void expect_near(Vec3f a, Vec3f b, float tolerance = kRounding) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "component " << c;
}

Quatf about_y(float angle_degrees) { return glm::angleAxis(radians(angle_degrees), Vec3f(0, 1, 0)); }

Scene one_node(NodeAnimation animation) {
  Scene scene;
  scene.nodes.resize(1);
  animation.node = 0;
  scene.timeline.animations.push_back(animation);
  return scene;
}

Vec3f moved(const Scene& scene, double time, Vec3f p) {
  return transform_point(evaluate(scene, time).world_from_node.back(), p);
}

TEST(Evaluate, transform_scales_then_rotates_then_moves) {
  Scene scene;
  scene.nodes.resize(1);
  scene.nodes[0].local = {{1, 2, 3}, about_y(90), {2, 3, 4}};
  // (1, 0, 0) is scaled to (2, 0, 0), rotated by 90 degrees about y to (0, 0, -2), and translated to (1, 2, 1).
  expect_near(moved(scene, 0, {1, 0, 0}), {1, 2, 1});
}

TEST(Evaluate, parents_must_come_first) {
  for (const int parent : {-2, 1, 7}) {
    Scene scene;
    scene.nodes.resize(2);
    scene.nodes[1].parent = parent;
    EXPECT_THROW(evaluate(scene, 0), Error) << parent;
  }
}

TEST(Evaluate, missing_animated_node_is_an_error) {
  for (const int node : {-1, 1}) {
    Scene scene = one_node({});
    scene.timeline.animations[0].node = node;
    EXPECT_THROW(evaluate(scene, 0), Error) << node;
  }
}

TEST(Evaluate, unnormalised_rotation_does_not_scale) {
  Scene scene;
  scene.nodes.resize(1);
  scene.nodes[0].local.rotation = 3.0f * about_y(90);
  expect_near(moved(scene, 0, {1, 0, 0}), {0, 0, -1});
}

TEST(Evaluate, child_moves_with_its_parent) {
  NodeAnimation turn;
  turn.rotation = {{0, 1}, {about_y(0), about_y(90)}};
  Scene scene = one_node(turn);
  Node child;
  child.parent = 0;
  child.local.translation = {2, 0, 0};
  scene.nodes.push_back(child);
  expect_near(moved(scene, 0, Vec3f(0)), {2, 0, 0});
  expect_near(moved(scene, 1, Vec3f(0)), {0, 0, -2});
}

TEST(Evaluate, matrix_replaces_transform_and_animation) {
  NodeAnimation move;
  move.translation = {{0, 1}, {Vec3f(0), Vec3f(9)}};
  Scene scene = one_node(move);
  scene.nodes[0].local.translation = {5, 5, 5};
  scene.nodes[0].matrix = Affine3f{Mat3f(2.0f), {1, 0, 0}};
  expect_near(moved(scene, 1, {1, 1, 1}), {3, 2, 2});
}

TEST(Evaluate, empty_channel_keeps_the_node_s_value) {
  NodeAnimation move;
  move.translation = {{0, 1}, {Vec3f(0), Vec3f(1)}};
  Scene scene = one_node(move);
  scene.nodes[0].local.scale = Vec3f(3.0f);
  expect_near(moved(scene, 1, {1, 1, 1}), {4, 4, 4});
}

TEST(Evaluate, linear_translation_is_proportional_between_keys) {
  NodeAnimation move;
  move.translation = {{1, 3}, {{0, 0, 0}, {8, 4, -2}}};
  expect_near(moved(one_node(move), 1.5, Vec3f(0)), {2, 1, -0.5});
}

TEST(Evaluate, end_values_hold_outside_the_keys) {
  NodeAnimation move;
  move.translation = {{1, 3}, {{1, 0, 0}, {8, 0, 0}}};
  const Scene scene = one_node(move);
  for (const double time : {-5.0, 0.0, 1.0}) expect_near(moved(scene, time, Vec3f(0)), {1, 0, 0});
  for (const double time : {3.0, 100.0}) expect_near(moved(scene, time, Vec3f(0)), {8, 0, 0});
}

TEST(Evaluate, step_holds_until_the_next_key) {
  NodeAnimation move;
  move.translation = {{0, 1, 2}, {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, Interpolation::kStep};
  const Scene scene = one_node(move);
  expect_near(moved(scene, 0.999, Vec3f(0)), {1, 0, 0});
  expect_near(moved(scene, 1.0, Vec3f(0)), {2, 0, 0});
  expect_near(moved(scene, 1.5, Vec3f(0)), {2, 0, 0});
}

TEST(Evaluate, linear_rotation_turns_uniformly) {
  NodeAnimation turn;
  turn.rotation = {{0, 1}, {about_y(0), about_y(90)}};
  const Scene scene = one_node(turn);
  for (const float part : {0.1f, 0.25f, 0.5f, 0.9f})
    expect_near(moved(scene, part, {1, 0, 0}), {std::cos(part * kPi / 2), 0, -std::sin(part * kPi / 2)});
}

TEST(Evaluate, linear_rotation_takes_the_shorter_arc) {
  NodeAnimation turn;
  turn.rotation = {{0, 1}, {about_y(0), -about_y(90)}};  // -q is the same rotation as q
  expect_near(moved(one_node(turn), 0.5, {1, 0, 0}), {std::sqrt(0.5f), 0, -std::sqrt(0.5f)});
}

TEST(Evaluate, equal_rotation_keys_are_constant) {
  NodeAnimation turn;
  turn.rotation = {{0, 1}, {about_y(90), about_y(90)}};
  expect_near(moved(one_node(turn), 0.3, {1, 0, 0}), {0, 0, -1});
}

TEST(Evaluate, cubic_spline_weighs_tangents_by_the_interval) {
  NodeAnimation move;
  // x goes from 1 (out-tangent 3) to 5 (in-tangent -2) in 2 s. After a quarter of this time, the cubic Hermite spline
  // has the value 85/32 = 2.65625.
  move.translation = {{1, 3}, {Vec3f(77), {1, 0, 0}, {3, 0, 0}, {-2, 0, 0}, {5, 0, 0}, Vec3f(77)}, Interpolation::kCubicSpline};
  const Scene scene = one_node(move);
  expect_near(moved(scene, 1.5, Vec3f(0)), {2.65625, 0, 0});
  expect_near(moved(scene, 0.0, Vec3f(0)), {1, 0, 0});
  expect_near(moved(scene, 3.0, Vec3f(0)), {5, 0, 0});
}

TEST(Evaluate, cubic_spline_rotation_is_normalised) {
  NodeAnimation turn;
  const Quatf none(0, 0, 0, 0);
  turn.rotation = {{0, 1}, {none, about_y(0), none, none, about_y(90), none}, Interpolation::kCubicSpline};
  // Without tangents, the value half-way is the mean of both quaternions, normalised: the rotation by 45 degrees.
  expect_near(moved(one_node(turn), 0.5, {1, 0, 0}), {std::sqrt(0.5f), 0, -std::sqrt(0.5f)});
}

TEST(Evaluate, equal_times_give_equal_bits) {
  NodeAnimation turn;
  turn.rotation = {{0, 1}, {about_y(0), about_y(80)}};
  const Scene scene = one_node(turn);
  EXPECT_TRUE(evaluate(scene, 0.37).world_from_node[0] == evaluate(scene, 0.37).world_from_node[0]);
}

TEST(ResolvedScene, no_node_means_identity) { EXPECT_TRUE(ResolvedScene().of(-1) == Affine3f()); }

TEST(MovingNodes, animated_nodes_and_their_descendants_move) {
  Scene scene;
  scene.nodes.resize(4);
  scene.nodes[2].parent = 1;
  scene.nodes[3].parent = 0;
  NodeAnimation turn;
  turn.node = 1;
  turn.rotation = {{0, 1}, {about_y(0), about_y(10)}};
  scene.timeline.animations.push_back(turn);
  EXPECT_EQ(moving_nodes(scene), (std::vector<bool>{false, true, true, false}));
}

TEST(MovingNodes, constant_channels_do_not_move) {
  NodeAnimation still;
  still.translation = {{0}, {Vec3f(1)}};
  still.rotation = {{0, 1}, {about_y(5), about_y(5)}};
  still.scale = {{0, 1}, {Vec3f(0), Vec3f(2), Vec3f(0), Vec3f(0), Vec3f(2), Vec3f(0)}, Interpolation::kCubicSpline};
  EXPECT_FALSE(moving_nodes(one_node(still))[0]);
}

TEST(MovingNodes, cubic_tangents_alone_move) {
  NodeAnimation swing;
  swing.scale = {{0, 1}, {Vec3f(0), Vec3f(2), Vec3f(1), Vec3f(0), Vec3f(2), Vec3f(0)}, Interpolation::kCubicSpline};
  EXPECT_TRUE(moving_nodes(one_node(swing))[0]);
}

TEST(MovingNodes, matrix_node_does_not_move) {
  NodeAnimation move;
  move.translation = {{0, 1}, {Vec3f(0), Vec3f(1)}};
  Scene scene = one_node(move);
  scene.nodes[0].matrix = Affine3f{};
  EXPECT_FALSE(moving_nodes(scene)[0]);
}

Bounds3f bounds_of(Shape shape, const Transform& transform = {}) {
  Scene scene;
  scene.nodes.resize(1);
  scene.nodes[0].local = transform;
  scene.shapes.push_back(std::move(shape));
  scene.instances.push_back({"", 0, -1, 0});
  return finite_bounds(scene, evaluate(scene, 0));
}

TEST(FiniteBounds, scene_of_planes_has_none) {
  EXPECT_TRUE(bounds_of(Planes{Plane{}}).empty());
  EXPECT_TRUE(finite_bounds(Scene{}, ResolvedScene{}).empty());
}

TEST(FiniteBounds, mesh_bounds_are_tight) {
  const Mesh diamond{{{1, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}}, {}, {}, {{0, 1, 2}, {0, 2, 3}}};
  const Bounds3f b = bounds_of(diamond, {{0, 0, 0}, about_y(45), Vec3f(1)});
  expect_near(b.upper, {std::sqrt(0.5f), 0, std::sqrt(0.5f)});
  expect_near(b.lower, -b.upper);
}

TEST(FiniteBounds, unused_vertices_do_not_count) {
  Mesh mesh{{{1, 0, 0}, {0, 1, 0}, {500, 500, 500}, {0, 0, 1}}, {}, {}, {{0, 1, 3}}};
  EXPECT_EQ(bounds_of(mesh).upper, Vec3f(1));
  mesh.targets.push_back({.positions = std::vector<Vec3f>(4, Vec3f(1, 0, 0))});
  Scene scene;
  scene.nodes.emplace_back().morph_weights = {1.0f};
  scene.shapes.push_back(mesh);
  scene.instances.push_back({"", 0, -1, 0});
  EXPECT_EQ(finite_bounds(scene, evaluate(scene, 0)).upper, Vec3f(2, 1, 1));
}

TEST(FiniteBounds, sphere_is_exact_under_uneven_scale) {
  const Bounds3f b = bounds_of(Spheres{{{1, 0, 0}, 0.5f}}, {{0, 1, 0}, about_y(0), {2, 1, 3}});
  expect_near(b.lower, {1, 0.5, -1.5});
  expect_near(b.upper, {3, 1.5, 1.5});
}

TEST(FiniteBounds, turned_sphere_does_not_grow) {
  const Bounds3f b = bounds_of(Spheres{{{0, 0, 0}, 1.0f}}, {{0, 0, 0}, about_y(45), Vec3f(1)});
  expect_near(b.upper, {1, 1, 1});
}

TEST(FiniteBounds, slanted_cylinder_is_exact) {
  // Each end disc has radius 5 and the normal (3, 4, 0) / 5, so it extends 4 along x, 3 along y and 5 along z.
  const Bounds3f b = bounds_of(Cylinders{{{0, 0, 0}, {3, 4, 0}, 5.0f}});
  expect_near(b.lower, {-4, -3, -5});
  expect_near(b.upper, {7, 7, 5});
}

TEST(FiniteBounds, ring_is_flat_along_its_normal) {
  const Bounds3f b = bounds_of(Rings{{{1, 2, 3}, {0, 1, 0}, 0.5f, 2.0f}});
  expect_near(b.lower, {-1, 2, 1});
  expect_near(b.upper, {3, 2, 5});
}

TEST(FiniteBounds, box_turns_with_its_node) {
  const Bounds3f b = bounds_of(Boxes{{{-1, -2, -3}, {1, 2, 3}}}, {{0, 0, 0}, about_y(90), Vec3f(1)});
  expect_near(b.upper, {3, 2, 1});
}

TEST(FiniteBounds, all_instances_count) {
  Scene scene;
  scene.nodes.resize(2);
  scene.nodes[1].local.translation = {10, 0, 0};
  scene.shapes.push_back(Boxes{Box{}});
  scene.instances = {{"", 0, -1, 0}, {"", 0, -1, 1}, {"", 0, -1, -1}};
  const Bounds3f b = finite_bounds(scene, evaluate(scene, 0));
  expect_near(b.lower, {-1, -1, -1});
  expect_near(b.upper, {11, 1, 1});
}

TEST(FiniteBounds, along_another_frames_axes_are_as_tight) {
  Scene scene;
  scene.shapes.push_back(Boxes{Box{Vec3f(-1, -1, -1), Vec3f(1, 1, 1)}});
  scene.instances.push_back({"box", 0, -1, -1});
  scene.nodes.resize(1);
  scene.nodes[0].local = {{5, 0, 0}, about_y(45), Vec3f(1)};
  scene.instances[0].node = 0;
  const ResolvedScene resolved = evaluate(scene, 0);
  // The rotated box extends sqrt(2) along the world's axes, and 1 along its own.
  EXPECT_NEAR(finite_bounds(scene, resolved).upper.x, 5.0f + std::sqrt(2.0f), 1e-5f);
  const Bounds3f own = finite_bounds(scene, resolved, inverse(resolved.of(0)));
  expect_near(own.lower, Vec3f(-1), 1e-5f);
  expect_near(own.upper, Vec3f(1), 1e-5f);
}

}  // namespace
}  // namespace lippmann
