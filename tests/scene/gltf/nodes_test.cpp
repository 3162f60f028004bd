#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "lippmann/scene/timeline.hpp"
#include "scene/deform.hpp"
#include "scene/gltf/gltf_builder.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using test::GltfBuilder;
using test::Json;
using test::parse;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const float kHalfRoot = std::sqrt(0.5f);

/// Tolerance for rounding of floats near 1.
constexpr float kFloatRounding = 1e-6f;

void expect_near(Vec3f actual, Vec3f expected, float tolerance = kFloatRounding) {
  EXPECT_LE(glm::length(actual - expected), tolerance) << actual.x << " " << actual.y << " " << actual.z;
}

std::string message_of(const GltfBuilder& builder) {
  return error_message([&] { parse(builder); });
}

TEST(GltfNodes, parents_come_first) {
  GltfBuilder b;
  b.add_node({{"name", "grandchild"}});
  b.add_node({{"name", "child"}, {"children", {0}}});
  b.add_node({{"name", "root"}, {"children", {3, 1}}});
  b.add_node({{"name", "first child"}});
  const Scene scene = parse(b);
  std::vector<std::string> names;
  std::vector<int> parents;
  for (const Node& node : scene.nodes) names.push_back(node.name), parents.push_back(node.parent);
  EXPECT_THAT(names, ElementsAre("root", "first child", "child", "grandchild"));
  EXPECT_THAT(parents, ElementsAre(-1, 0, 0, 2));
}

TEST(GltfNodes, world_transform_composes_levels) {
  GltfBuilder b;
  // Node 0 rotates by 90 degrees about z, which turns x to y.
  b.add_node(
      {{"translation", {10, 0, 0}}, {"rotation", {0, 0, kHalfRoot, kHalfRoot}}, {"scale", {2, 3, 4}}, {"children", {1}}});
  b.add_node({{"translation", {1, 0, 0}}});
  const Scene scene = parse(b);
  const ResolvedScene rest = evaluate(scene, 0.0);
  // Node 1 translates (1, 1, 1) to (2, 1, 1). Node 0 scales this to (4, 3, 4), rotates it to (-3, 4, 4), and translates
  // it to (7, 4, 4).
  expect_near(transform_point(rest.of(1), {1, 1, 1}), {7, 4, 4}, 4 * kFloatRounding);
}

TEST(GltfNodes, matrix_is_read_by_columns) {
  GltfBuilder b;
  b.add_node({{"matrix", {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}});
  const Scene scene = parse(b);
  expect_near(transform_point(evaluate(scene, 0.0).of(0), {1, 0, 0}), {5, 8, 7});
}

TEST(GltfNodes, projective_matrix_is_an_error) {
  GltfBuilder b;
  b.add_node({{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0.5, 0, 0, 0, 1}}});
  EXPECT_THAT(message_of(b), HasSubstr("nodes[0].matrix: is not an affine transform"));
}

TEST(GltfNodes, rotation_is_normalized) {
  GltfBuilder b;
  b.add_node({{"rotation", {0, 0, 0, 2}}});
  EXPECT_EQ(parse(b).nodes[0].local.rotation, Quatf(1, 0, 0, 0));
}

TEST(GltfNodes, rotation_of_zero_length_is_an_error) {
  GltfBuilder b;
  b.add_node({{"rotation", {0, 0, 0, 0}}});
  EXPECT_EQ(message_of(b), "a.glb: nodes[0].rotation: is not a unit quaternion");
}

TEST(GltfNodes, infinite_product_is_an_error) {
  GltfBuilder b;
  b.add_node({{"scale", {1e30, 1, 1}}, {"children", {1}}});
  b.add_node({{"scale", {1e30, 1, 1}}});
  EXPECT_EQ(message_of(b), "a.glb: nodes[1]: has a world transform that is not finite");
}

TEST(GltfNodes, node_with_two_parents_is_an_error) {
  GltfBuilder b;
  b.add_node({{"children", {2}}});
  b.add_node({{"children", {2}}});
  b.add_node(Json::object());
  EXPECT_EQ(message_of(b), "a.glb: nodes[2]: has two parents, nodes[0] and nodes[1]");
}

TEST(GltfNodes, cycle_is_an_error) {
  GltfBuilder b;
  b.add_node(Json::object());
  b.add_node({{"children", {2}}});
  b.add_node({{"children", {1}}});
  EXPECT_EQ(message_of(b), "a.glb: nodes[1]: is part of or below a cycle of nodes");
}

TEST(GltfNodes, self_child_is_an_error) {
  GltfBuilder b;
  b.add_node({{"children", {0}}});
  EXPECT_THAT(message_of(b), HasSubstr("nodes[0]: is part of or below a cycle"));
}

GltfBuilder chain_of_three(const Json& listed) {
  GltfBuilder b;
  b.add_node({{"name", "top"}, {"translation", {1, 0, 0}}, {"children", {1}}});
  b.add_node({{"name", "middle"}, {"translation", {0, 1, 0}}, {"children", {2}}});
  b.add_node({{"name", "end"}, {"translation", {0, 0, 1}}});
  b.add("scenes", {{"nodes", listed}});
  return b;
}

TEST(GltfNodes, listed_child_is_shown_once_with_warning) {
  for (const Json& listed : {Json{0, 1}, Json{1, 0}, Json{2, 0}, Json{0, 1, 2}}) {
    std::vector<std::string> warnings;
    const Scene scene = parse(chain_of_three(listed), &warnings);
    ASSERT_EQ(scene.nodes.size(), 3u) << listed;
    EXPECT_EQ(scene.nodes[2].name, "end");
    expect_near(evaluate(scene, 0.0).of(2).translation, {1, 1, 1});
    EXPECT_EQ(warnings.size(), 1u);
  }
}

TEST(GltfNodes, child_listed_alone_is_a_root) {
  std::vector<std::string> warnings;
  const Scene scene = parse(chain_of_three({1}), &warnings);
  ASSERT_EQ(scene.nodes.size(), 2u);
  EXPECT_EQ(scene.nodes[0].name, "middle");
  EXPECT_EQ(scene.nodes[0].parent, -1);
  expect_near(evaluate(scene, 0.0).of(1).translation, {0, 1, 1});
  EXPECT_THAT(warnings, ElementsAre("a.glb: scenes[0] lists nodes[1], which is not a root but a child of nodes[0]: it is shown "
                                    "once, below its parent if that is in the scene"));
}

const Json kInvisible = {{"KHR_node_visibility", {{"visible", false}}}};

TEST(GltfVisibility, hidden_node_hides_meshes_and_lights_below) {
  GltfBuilder b;
  b.root["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  b.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}});
  const int mesh = b.add_triangle();
  b.add_node({{"name", "hidden"}, {"mesh", mesh}, {"children", {1}}, {"extensions", kInvisible}});
  b.add_node(
      {{"mesh", mesh}, {"camera", 0}, {"children", {2}}, {"extensions", {{"KHR_node_visibility", {{"visible", true}}}}}});
  b.add_node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  b.add_node({{"name", "shown"}, {"mesh", mesh}, {"extensions", {{"KHR_node_visibility", Json::object()}}}});
  b.root["extensionsRequired"] = {"KHR_node_visibility"};
  const Scene scene = parse(b);
  ASSERT_EQ(scene.instances.size(), 1u);
  EXPECT_EQ(scene.instances[0].name, "shown");
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_EQ(scene.cameras.size(), 1u);
}

TEST(GltfVisibility, warns_if_nothing_is_visible) {
  GltfBuilder b;
  b.add_node({{"mesh", b.add_triangle()}, {"extensions", kInvisible}});
  std::vector<std::string> warnings;
  EXPECT_TRUE(parse(b, &warnings).instances.empty());
  EXPECT_THAT(warnings, Contains("a.glb: all nodes with a mesh are invisible (KHR_node_visibility)"));
}

TEST(GltfVisibility, non_boolean_is_an_error) {
  GltfBuilder b;
  b.add_node({{"extensions", {{"KHR_node_visibility", {{"visible", "no"}}}}}});
  EXPECT_EQ(message_of(b), "a.glb: nodes[0].extensions.KHR_node_visibility.visible: is not true or false");
}

TEST(GltfNodes, chain_of_100000_nodes_is_read) {
  GltfBuilder b;
  constexpr int kLength = 100'000;
  for (int i = 0; i + 1 < kLength; ++i) b.add_node({{"children", {i + 1}}});
  b.add_node(Json::object());
  EXPECT_EQ(parse(b).nodes.back().parent, kLength - 2);
}

TEST(GltfNodes, reads_only_the_default_scene) {
  GltfBuilder b;
  b.add_node({{"name", "a"}});
  b.add_node({{"name", "b"}});
  b.add("scenes", {{"nodes", {0}}});
  b.add("scenes", {{"nodes", {1}}});
  b.root["scene"] = 1;
  std::vector<std::string> warnings;
  const Scene scene = parse(b, &warnings);
  ASSERT_EQ(scene.nodes.size(), 1u);
  EXPECT_EQ(scene.nodes[0].name, "b");
  EXPECT_THAT(warnings, Contains("a.glb: only the default scene, scenes[1] of 2, is read"));
}

/// Joint 0 translates by (10, 0, 0). Joint 1 rotates x to y, and its inverse bind matrix translates by (0, 0, 1).
GltfBuilder skinned_triangle(const std::vector<Vec4f>& weights) {
  GltfBuilder b;
  const glm::mat4 identity(1.0f);
  glm::mat4 bind(1.0f);
  bind[3] = {0, 0, 1, 1};
  const int matrices = b.add_accessor(std::vector<glm::mat4>{identity, bind}, test::kFloat, "MAT4", 2);
  const int joints =
      b.add_accessor(std::vector<std::uint8_t>{0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, test::kUnsignedByte, "VEC4", 3);
  const int normals = b.add_accessor(std::vector<Vec3f>(3, Vec3f(1, 0, 0)));
  const int mesh =
      b.add_triangle({{"attributes", {{"JOINTS_0", joints}, {"WEIGHTS_0", b.add_accessor(weights)}, {"NORMAL", normals}}}});
  b.add("skins", {{"joints", {1, 2}}, {"inverseBindMatrices", matrices}});
  b.add_node({{"mesh", mesh}, {"skin", 0}, {"translation", {100, 100, 100}}});
  b.add_node({{"translation", {10, 0, 0}}});
  b.add_node({{"rotation", {0, 0, kHalfRoot, kHalfRoot}}});
  return b;
}

Vec3f posed(const Scene& scene, std::size_t vertex, double time = 0.0) {
  validate(scene, "a.glb");
  const ResolvedScene resolved = evaluate(scene, time);
  return MeshPose(scene, scene.instances.at(0), resolved).position(vertex);
}

TEST(GltfSkin, joints_bind_matrices_and_weights_are_read) {
  const Scene scene = parse(skinned_triangle({{1, 0, 0, 0}, {0, 1, 0, 0}, {0.5f, 0.5f, 0, 0}}));
  ASSERT_EQ(scene.skins.size(), 1u);
  EXPECT_THAT(scene.skins[0].joints, ElementsAre(1, 2));
  EXPECT_EQ(std::get<Mesh>(scene.shapes.at(0)).skin.per_vertex, 4);
  expect_near(posed(scene, 0), {10, 0, 0});
  expect_near(posed(scene, 1), {0, 1, 1});  // (1, 0, 0) + (0, 0, 1) = (1, 0, 1), rotated: (0, 1, 1)
  // Joint 0 moves vertex 2 at (0, 1, 0) to (10, 1, 0), joint 1 to (-1, 0, 1). The result is the mean.
  expect_near(posed(scene, 2), {4.5f, 0.5f, 0.5f}, 4 * kFloatRounding);
}

TEST(GltfSkin, hidden_joints_still_move_the_mesh) {
  GltfBuilder b = skinned_triangle({{1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}});
  b.root["nodes"][1]["extensions"] = kInvisible;
  expect_near(posed(parse(b), 0), {10, 0, 0});
}

TEST(GltfSkin, animated_joints_move_the_mesh) {
  GltfBuilder b = skinned_triangle({{1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}});
  const int times = b.add_accessor(std::vector<float>{0, 1}), places = b.add_accessor(std::vector<Vec3f>{{0, 0, 0}, {0, 8, 0}});
  b.add("animations", {{"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}},
                       {"samplers", {{{"input", times}, {"output", places}}}}});
  expect_near(posed(parse(b), 1, 0.25), {1, 2, 0});
}

TEST(GltfSkin, normalises_weights) {
  const Scene scene = parse(skinned_triangle({{2, 0, 0, 0}, {0.25f, 0, 0, 0}, {0, 0, 0, 0}}));
  expect_near(posed(scene, 0), {10, 0, 0});
  expect_near(posed(scene, 1), {11, 0, 0});
  expect_near(posed(scene, 2), {10, 1, 0});  // without weights, a vertex follows the first joint
}

TEST(GltfSkin, second_set_of_joints_counts_too) {
  GltfBuilder b = skinned_triangle({{1, 0, 0, 0}, {0.5f, 0, 0, 0}, {1, 0, 0, 0}});
  Json& attributes = b.root["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_1"] = attributes["JOINTS_0"];
  attributes["WEIGHTS_1"] = b.add_accessor(std::vector<Vec4f>{{0, 0, 0, 0}, {0, 0.5f, 0, 0}, {0, 0, 0, 0}});
  // Joint 0 moves vertex 1 at (1, 0, 0) to (11, 0, 0), joint 1 to (0, 1, 1). The result is the mean.
  expect_near(posed(parse(b), 1), {5.5f, 0.5f, 0.5f}, 4 * kFloatRounding);
}

TEST(GltfSkin, skips_unused_skins) {
  GltfBuilder b = skinned_triangle({{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}});
  b.root["nodes"][0].erase("skin");
  b.root["skins"][0]["joints"] = {1, 2, 0};
  EXPECT_TRUE(parse(b).skins.empty());
}

TEST(GltfSkin, infinite_pose_is_an_error) {
  GltfBuilder b = skinned_triangle({{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}});
  b.root["nodes"][1]["scale"] = {3e38, 1, 1};
  b.root["nodes"][1]["translation"] = {3e38, 0, 0};
  b.root["nodes"][1]["rotation"] = {0, 0, 1, 0};
  b.root["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = b.add_accessor(std::vector<Vec3f>(3, Vec3f(-2, 0, 0)));
  EXPECT_EQ(message_of(b), "a.glb: meshes[0].primitives[0]: skinning or morphing moves vertex 0 too far away");
}

TEST(GltfSkin, joint_beyond_the_skin_is_an_error) {
  GltfBuilder b = skinned_triangle({{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}});
  b.root["skins"][0]["joints"] = {1};
  EXPECT_EQ(message_of(b), "a.glb: meshes[0].primitives[0]: vertex 1 refers to joint 1; accepted: 0 to 0");
}

TEST(GltfSkin, too_few_bind_matrices_are_an_error) {
  GltfBuilder b = skinned_triangle({{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}});
  b.root["skins"][0]["joints"] = {1, 2, 0};
  EXPECT_EQ(message_of(b), "a.glb: skins[0]: has 3 joints, but 2 inverse bind matrices");
}

TEST(GltfSkin, joint_outside_the_scene_is_an_error) {
  GltfBuilder b = skinned_triangle({{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}});
  b.add("scenes", {{"nodes", {0, 1}}});
  EXPECT_EQ(message_of(b), "a.glb: skins[0]: has the joint nodes[2], which is not in the scene");
}

/// The first morph target lifts vertex 1 by 1. The second contains only normals.
GltfBuilder morphing_triangle() {
  GltfBuilder b;
  const int lift = b.add_accessor(std::vector<Vec3f>{{0, 0, 0}, {0, 0, 1}, {0, 0, 0}});
  const int normals = b.add_accessor(std::vector<Vec3f>(3, Vec3f(0, 0, 1)));
  b.add_node({{"mesh", b.add_triangle({{"attributes", {{"NORMAL", normals}}},
                                       {"targets", {{{"POSITION", lift}}, {{"NORMAL", normals}, {"COLOR_0", lift}}}}})}});
  return b;
}

TEST(GltfMorph, weights_from_node_then_mesh_then_zero) {
  GltfBuilder b = morphing_triangle();
  EXPECT_THAT(parse(b).nodes[0].morph_weights, ElementsAre(0.0f, 0.0f));
  b.root["meshes"][0]["weights"] = {0.5, 0.25};
  EXPECT_THAT(parse(b).nodes[0].morph_weights, ElementsAre(0.5f, 0.25f));
  b.root["nodes"][0]["weights"] = {2, 0};
  EXPECT_THAT(parse(b).nodes[0].morph_weights, ElementsAre(2.0f, 0.0f));
  expect_near(posed(parse(b), 1), {1, 0, 2});
}

TEST(GltfMorph, animated_weights_are_grouped_by_key) {
  GltfBuilder b = morphing_triangle();
  const int times = b.add_accessor(std::vector<float>{0, 1}), weights = b.add_accessor(std::vector<float>{0, 0, 4, 0});
  b.add("animations", {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}},
                       {"samplers", {{{"input", times}, {"output", weights}}}}});
  expect_near(posed(parse(b), 1, 0.5), {1, 0, 2});
  b.accessor(weights)["count"] = 3;
  EXPECT_EQ(message_of(b), "a.glb: animations[0].channels[0]: has 2 keys, but 3 values; accepted: 2 per key");
}

TEST(GltfMorph, wrong_number_of_weights_is_an_error) {
  GltfBuilder b = morphing_triangle();
  b.root["nodes"][0]["weights"] = {1};
  EXPECT_EQ(message_of(b), "a.glb: nodes[0]: has 1 weights for 2 morph targets");
}

TEST(GltfMorph, target_with_another_count_is_an_error) {
  GltfBuilder b = morphing_triangle();
  b.accessor(0)["count"] = 2;
  EXPECT_EQ(message_of(b), "a.glb: meshes[0].primitives[0]: has 3 positions, but 2 values of POSITION");
}

TEST(GltfMorph, differing_target_counts_are_an_error) {
  GltfBuilder b = morphing_triangle();
  Json bare = b.root["meshes"][0]["primitives"][0];
  bare.erase("targets");
  b.root["meshes"][0]["primitives"].push_back(bare);
  EXPECT_EQ(message_of(b), "a.glb: meshes[0].primitives[1]: has 0 morph targets, the mesh's first primitive 2");
}

TEST(GltfMorph, counts_morphing_nodes_before_posing) {
  GltfBuilder b = morphing_triangle();
  for (int i = 0; i < 100; ++i) b.add_node({{"mesh", 0}});
  GltfLimits limits;
  limits.unpacked_bytes = 10'000;
  EXPECT_THAT(error_message([&] { parse(b, nullptr, limits); }), HasSubstr("the unpacked scene needs too much memory"));
}

template <class T>
GltfBuilder animated(const char* path, const char* interpolation, const std::vector<float>& times,
                     const std::vector<T>& values) {
  GltfBuilder b;
  b.add_node(Json::object());
  const int input = b.add_accessor(times), output = b.add_accessor(values);
  b.add("animations", {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}},
                       {"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}}});
  return b;
}

Vec3f position_at(const Scene& scene, double time) { return evaluate(scene, time).of(0).translation; }

TEST(GltfAnimation, step_holds_each_key_until_the_next) {
  const Scene scene = parse(animated<Vec3f>("translation", "STEP", {0, 1}, {{1, 0, 0}, {2, 0, 0}}));
  EXPECT_EQ(position_at(scene, 0.99), Vec3f(1, 0, 0));
  EXPECT_EQ(position_at(scene, 1.0), Vec3f(2, 0, 0));
}

TEST(GltfAnimation, linear_goes_straight_and_holds_the_ends) {
  const Scene scene = parse(animated<Vec3f>("translation", "LINEAR", {1, 3}, {{1, 0, 0}, {2, 4, 0}}));
  EXPECT_EQ(position_at(scene, 0.0), Vec3f(1, 0, 0));
  EXPECT_EQ(position_at(scene, 2.0), Vec3f(1.5f, 2, 0));
  EXPECT_EQ(position_at(scene, 9.0), Vec3f(2, 4, 0));
}

TEST(GltfAnimation, cubic_spline_reads_tangents_around_each_value) {
  // Each key has an in-tangent, a value and an out-tangent. x goes from 1 (out-tangent 3) at 0 s to 5 (in-tangent -2)
  // at 2 s. At 0.5 s, the cubic Hermite spline has the value 85/32.
  const Scene scene = parse(animated<Vec3f>("translation", "CUBICSPLINE", {0, 2},
                                            {{9, 0, 0}, {1, 0, 0}, {3, 0, 0}, {-2, 0, 0}, {5, 0, 0}, {9, 0, 0}}));
  expect_near(position_at(scene, 0.5), {85.0f / 32.0f, 0, 0}, 4 * kFloatRounding);
}

TEST(GltfAnimation, rotation_is_xyzw_along_the_arc) {
  const Scene scene = parse(animated<Vec4f>("rotation", "LINEAR", {0, 1}, {{0, 0, 0, 1}, {0, 0, kHalfRoot, kHalfRoot}}));
  // Half-way, the rotation is by 45 degrees about z.
  expect_near(transform_vector(evaluate(scene, 0.5).of(0), {1, 0, 0}), {kHalfRoot, kHalfRoot, 0});
}

TEST(GltfAnimation, short_rotation_is_a_unit_quaternion) {
  GltfBuilder b = animated<Vec4f>("rotation", "LINEAR", {0, 1}, {{0, 0, 0, 1}, {0, 0, 0, 1}});
  const int shorts = b.add_accessor(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 23170, 23170}, 5122, "VEC4", 2);
  b.accessor(shorts)["normalized"] = true;
  b.root["animations"][0]["samplers"][0]["output"] = shorts;
  const Scene scene = parse(b);
  // 23170 / 32767 differs from sqrt(1/2) by 4e-5; normalisation removes this.
  expect_near(transform_vector(evaluate(scene, 1.0).of(0), {1, 0, 0}), {0, 1, 0});
}

TEST(GltfAnimation, scale_is_read) {
  const Scene scene = parse(animated<Vec3f>("scale", "LINEAR", {0, 1}, {{1, 1, 1}, {3, 1, 1}}));
  EXPECT_EQ(transform_vector(evaluate(scene, 0.5).of(0), {1, 0, 0}), Vec3f(2, 0, 0));
}

/// KHR_animation_pointer uses channels without a node.
TEST(GltfAnimation, channels_of_no_node_are_left_out) {
  GltfBuilder b = animated<Vec3f>("translation", "LINEAR", {0, 1}, {{1, 1, 1}, {3, 1, 1}});
  const Json pointer{{"pointer", "/materials/0/pbrMetallicRoughness/roughnessFactor"}};
  b.root["animations"][0]["channels"].push_back(
      {{"sampler", 0}, {"target", {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", pointer}}}}}});
  EXPECT_EQ(position_at(parse(b), 0.5), Vec3f(2, 1, 1));
}

TEST(GltfAnimation, channels_of_one_node_come_together) {
  GltfBuilder b = animated<Vec3f>("translation", "LINEAR", {0, 1}, {{1, 1, 1}, {3, 1, 1}});
  b.root["animations"][0]["channels"].push_back({{"sampler", 0}, {"target", {{"node", 0}, {"path", "scale"}}}});
  const Scene scene = parse(b);
  ASSERT_EQ(scene.timeline.animations.size(), 1u);
  EXPECT_EQ(scene.timeline.animations[0].scale.values.size(), 2u);
  EXPECT_NO_THROW(validate(scene, "a.glb"));
}

TEST(GltfAnimation, frame_count_is_length_times_rate) {
  // 1.5 s * 25 frames per second = 37.5 frames, rounded to 38
  EXPECT_EQ(parse(animated<Vec3f>("translation", "LINEAR", {0, 1.5f}, {{0, 0, 0}, {1, 0, 0}})).timeline.frame_count, 38);
}

TEST(GltfAnimation, single_key_gives_one_frame) {
  EXPECT_EQ(parse(animated<Vec3f>("translation", "LINEAR", {0}, {{1, 0, 0}})).timeline.frame_count, 1);
}

TEST(GltfAnimation, that_lasts_forever_is_an_error) {
  EXPECT_THAT(message_of(animated<Vec3f>("translation", "LINEAR", {0, 1e30f}, {{0, 0, 0}, {1, 0, 0}})),
              HasSubstr("animations[0]: lasts 1.0000000150474662e+30 s"));
}

TEST(GltfAnimation, times_must_increase) {
  EXPECT_EQ(message_of(animated<Vec3f>("translation", "LINEAR", {0, 1, 1}, {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}})),
            "a.glb: accessors[0]: key 2 at 1 s is not later than the one before it at 1 s");
}

TEST(GltfAnimation, time_must_be_a_number) {
  EXPECT_EQ(message_of(animated<Vec3f>("translation", "LINEAR", {0, NAN}, {{0, 0, 0}, {1, 0, 0}})),
            "a.glb: accessors[0]: element 1 is not finite");
}

TEST(GltfAnimation, negative_time_is_an_error) {
  EXPECT_THAT(message_of(animated<Vec3f>("translation", "LINEAR", {-1, 1}, {{0, 0, 0}, {1, 0, 0}})),
              HasSubstr("accessors[0]: the first key's time is -1; accepted: 0 or more"));
}

TEST(GltfAnimation, value_count_must_match_keys) {
  EXPECT_EQ(message_of(animated<Vec3f>("translation", "CUBICSPLINE", {0, 1}, {{0, 0, 0}, {1, 0, 0}})),
            "a.glb: animations[0].channels[0]: has 2 keys, but 2 values; accepted: 3 per key");
}

TEST(GltfAnimation, rotation_without_direction_is_an_error) {
  EXPECT_EQ(message_of(animated<Vec4f>("rotation", "LINEAR", {0, 1}, {{0, 0, 0, 1}, {0, 0, 0, 0}})),
            "a.glb: animations[0].channels[0]: the rotation of key 1 is not a unit quaternion");
}

TEST(GltfAnimation, node_with_matrix_is_an_error) {
  GltfBuilder b = animated<Vec3f>("translation", "LINEAR", {0, 1}, {{0, 0, 0}, {1, 0, 0}});
  b.root["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  EXPECT_THAT(message_of(b), HasSubstr("animations[0].channels[0]: animates nodes[0], which has a matrix"));
}

TEST(GltfAnimation, duplicate_target_is_an_error) {
  GltfBuilder b = animated<Vec3f>("translation", "LINEAR", {0, 1}, {{0, 0, 0}, {1, 0, 0}});
  b.root["animations"][0]["channels"].push_back(b.root["animations"][0]["channels"][0]);
  EXPECT_EQ(message_of(b), "a.glb: animations[0].channels[1]: has the same target as an earlier channel");
}

TEST(GltfAnimation, unknown_path_is_an_error) {
  EXPECT_EQ(message_of(animated<Vec3f>("wobble", "LINEAR", {0, 1}, {{0, 0, 0}, {1, 0, 0}})),
            "a.glb: animations[0].channels[0].target.path: is 'wobble'; accepted: translation, rotation, scale, weights");
}

GltfBuilder walk_and_run() {
  GltfBuilder b = animated<Vec3f>("translation", "LINEAR", {0, 1}, {{0, 0, 0}, {1, 0, 0}});
  b.root["animations"][0]["name"] = "Walk";
  Json run = b.root["animations"][0];
  run["name"] = "Run";
  run["samplers"][0]["input"] = b.add_accessor(std::vector<float>{0, 2});
  b.add("animations", run);
  return b;
}

int frames_of(const GltfBuilder& b, const std::string& animation) {
  return parse_gltf(b.glb(), "a.glb", {.frames_per_second = 25.0, .animation = animation}, Context{}).timeline.frame_count;
}

Timeline timeline_of_keys(const std::vector<float>& times) {
  const GltfBuilder b = animated<Vec3f>("translation", "LINEAR", times, std::vector<Vec3f>(times.size(), Vec3f(0.0f)));
  return parse_gltf(b.glb(), "a.glb", {}, Context{}).timeline;
}

std::vector<float> every(int step, double rate, int last) {
  std::vector<float> times;
  for (int frame = 0; frame <= last; frame += step) times.push_back(static_cast<float>(frame / rate));
  return times;
}

TEST(GltfAnimation, frames_fall_on_the_keys) {
  for (const double rate : {24.0, 25.0, 30.0, 60.0}) {
    const Timeline timeline = timeline_of_keys(every(1, rate, 2000));
    EXPECT_EQ(timeline.frames_per_second, rate);
    EXPECT_EQ(timeline.frame_count, 2000) << rate;
  }
  EXPECT_EQ(timeline_of_keys(every(10, 24.0, 40)).frames_per_second, 24.0) << "keys at every tenth frame";
  EXPECT_EQ(timeline_of_keys({0.0f, 0.0417f, 0.0833f, 0.125f}).frames_per_second, 24.0) << "times with four decimals";
}

TEST(GltfAnimation, unmatched_keys_use_30_fps) {
  EXPECT_EQ(timeline_of_keys({0.0f, 0.1234f, 0.5f}).frames_per_second, 30.0);
  EXPECT_FALSE(keys_fall_on_frames(timeline_of_keys({0.0f, 0.1234f, 0.5f}), 30.0));
  EXPECT_EQ(timeline_of_keys({0.0f, 1.0f}).frames_per_second, 30.0) << "where several rates suit";
}

TEST(GltfAnimation, selects_by_name_or_index) {
  const GltfBuilder b = walk_and_run();
  EXPECT_EQ(frames_of(b, ""), 25);
  EXPECT_EQ(frames_of(b, "Walk"), 25);
  EXPECT_EQ(frames_of(b, "Run"), 50);
  EXPECT_EQ(frames_of(b, "1"), 50);
}

TEST(GltfAnimation, names_come_before_indices) {
  GltfBuilder b = walk_and_run();
  b.root["animations"][0]["name"] = "1";
  EXPECT_EQ(frames_of(b, "1"), 25);
}

TEST(GltfAnimation, all_are_listed) {
  const Scene scene = parse(walk_and_run());
  EXPECT_THAT(scene.animation_names, ElementsAre("Walk", "Run"));
  EXPECT_EQ(scene.animation, 0);
}

TEST(GltfAnimation, unknown_selection_lists_names) {
  for (const char* name : {"Fly", "2", "-1", "1x"})
    EXPECT_EQ(error_message([&] { frames_of(walk_and_run(), name); }),
              std::string("animation: '") + name + "' is not in the file; accepted: Walk (0), Run (1)");
  EXPECT_EQ(error_message([] { frames_of(walk_and_run(), "Wlak"); }),
            "animation: 'Wlak' is not in the file, did you mean 'Walk'?; accepted: Walk (0), Run (1)");
  EXPECT_EQ(error_message([] { frames_of(skinned_triangle(std::vector<Vec4f>(3)), "Fly"); }),
            "animation: has no effect: the file has no animations; accepted: a file with animations");
}

TEST(GltfAnimation, ignores_nodes_outside_the_scene) {
  GltfBuilder b = animated<Vec3f>("translation", "LINEAR", {0, 1}, {{0, 0, 0}, {1, 0, 0}});
  b.add_node(Json::object());
  b.add("scenes", {{"nodes", {1}}});
  const Scene scene = parse(b);
  EXPECT_TRUE(scene.timeline.animations.empty());
  EXPECT_EQ(scene.timeline.frame_count, 1);
}

TEST(GltfAnimation, without_a_target_node_is_ignored) {
  GltfBuilder b = animated<Vec3f>("translation", "LINEAR", {0, 1}, {{0, 0, 0}, {1, 0, 0}});
  b.root["animations"][0]["channels"][0]["target"].erase("node");
  EXPECT_TRUE(parse(b).timeline.animations.empty());
}

}  // namespace
}  // namespace lippmann
