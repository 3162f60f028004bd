#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/scene/load.hpp"
#include "lippmann/scene/timeline.hpp"
#include "scene/gltf/gltf_builder.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using test::GltfBuilder;
using test::Json;
using test::parse;
using testing::HasSubstr;

GltfBuilder copies(GltfBuilder b, const Json& attributes) {
  b.add_node({{"mesh", b.add_triangle()},
              {"translation", {0, 0, 7}},
              {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", attributes}}}}}});
  b.root["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  return b;
}

TEST(GltfInstancing, copies_share_a_shape) {
  const float half_root = std::sqrt(0.5f);
  GltfBuilder b;
  const int places = b.add_accessor(std::vector<Vec3f>{{1, 0, 0}, {0, 2, 0}});
  const int rotations = b.add_accessor(std::vector<Vec4f>{{0, 0, 0, 1}, {0, 0, half_root, half_root}});
  const int scales = b.add_accessor(std::vector<Vec3f>{{1, 1, 1}, {3, 1, 1}});
  const Scene scene = parse(copies(b, {{"TRANSLATION", places}, {"ROTATION", rotations}, {"SCALE", scales}}));
  validate(scene, "a.glb");
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.shapes.size(), 1u);
  EXPECT_EQ(scene.instances[0].shape, scene.instances[1].shape);
  const ResolvedScene at = evaluate(scene, 0.0);
  EXPECT_EQ(transform_point(at.of(scene.instances[0].node), {1, 0, 0}), Vec3f(2, 0, 7));
  // The copy's point (1, 0, 0) is scaled to (3, 0, 0), rotated to (0, 3, 0), and translated.
  const Vec3f second = transform_point(at.of(scene.instances[1].node), {1, 0, 0});
  EXPECT_LE(glm::length(second - Vec3f(0, 5, 7)), 1e-5f);
}

TEST(GltfInstancing, attributes_that_are_left_out_change_nothing) {
  GltfBuilder b;
  const int scales = b.add_accessor(std::vector<Vec3f>{{1, 1, 1}, {2, 2, 2}, {3, 3, 3}});
  const Scene scene = parse(copies(b, {{"SCALE", scales}}));
  ASSERT_EQ(scene.instances.size(), 3u);
  EXPECT_EQ(transform_point(evaluate(scene, 0.0).of(scene.instances[2].node), {1, 0, 0}), Vec3f(3, 0, 7));
}

TEST(GltfInstancing, attributes_of_different_counts_are_an_error) {
  GltfBuilder b;
  const int two = b.add_accessor(std::vector<Vec3f>(2)), three = b.add_accessor(std::vector<Vec3f>(3));
  EXPECT_EQ(error_message([&] {
              parse(copies(b, {{"TRANSLATION", two}, {"SCALE", three}}));
            }),
            "a.glb: nodes[0].extensions.EXT_mesh_gpu_instancing: has 2 values of one attribute and 3 of another");
}

TEST(GltfInstancing, without_attributes_it_is_an_error) {
  EXPECT_THAT(error_message([&] { parse(copies({}, Json::object())); }),
              HasSubstr("has none of the attributes that place its copies"));
}

TEST(GltfInstancing, wrong_attribute_type_is_an_error) {
  GltfBuilder b;
  const int pairs = b.add_accessor(std::vector<Vec2f>(2));
  EXPECT_THAT(error_message([&] { parse(copies(b, {{"TRANSLATION", pairs}})); }), HasSubstr("accepted: VEC3"));
}

TEST(GltfInstancing, copy_without_a_rotation_is_an_error) {
  GltfBuilder b;
  const int rotations = b.add_accessor(std::vector<Vec4f>(1, Vec4f(0)));
  EXPECT_THAT(error_message([&] {
                parse(copies(b, {{"ROTATION", rotations}}));
              }),
              HasSubstr("the rotation of copy 0 is not a unit quaternion"));
}

TEST(GltfInstancing, infinite_copy_is_an_error) {
  GltfBuilder b;
  const int scales = b.add_accessor(std::vector<Vec3f>(1, Vec3f(3e38f)));
  GltfBuilder whole = copies(b, {{"SCALE", scales}});
  whole.root["nodes"][0]["scale"] = {10, 10, 10};
  EXPECT_EQ(error_message([&] { parse(whole); }), "a.glb: nodes[0]: has a world transform that is not finite");
}

TEST(GltfInstancing, rejects_billions_of_copies_early) {
  GltfBuilder b;
  const int places = b.add_accessor(std::vector<Vec3f>(1));
  b.accessor(places).erase("bufferView");
  b.accessor(places)["count"] = 2'000'000'000;
  EXPECT_THAT(error_message([&] { parse(copies(b, {{"TRANSLATION", places}})); }), HasSubstr("needs too much memory"));
}

}  // namespace
}  // namespace lippmann
