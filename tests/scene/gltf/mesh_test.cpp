#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/gltf/gltf_builder.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using test::GltfBuilder;
using test::Json;
using test::parse;
using test::parse_mesh;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

using Triangle = std::array<std::uint32_t, 3>;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Mesh five_vertices(const Json& more) {
  GltfBuilder b;
  const int positions = b.add_accessor(std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 0, 0}, {4, 1, 0}});
  Json primitive = {{"attributes", {{"POSITION", positions}}}};
  primitive.update(more);
  b.add_mesh(primitive);
  return parse_mesh(b);
}

TEST(GltfMesh, without_indices_uses_vertices_in_order) {
  EXPECT_THAT(five_vertices({{"mode", 4}}).triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(GltfMesh, strip_turns_every_other_triangle_around) {
  EXPECT_THAT(five_vertices({{"mode", 5}}).triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{1, 3, 2}, Triangle{2, 3, 4}));
}

TEST(GltfMesh, fan_turns_around_its_first_vertex) {
  EXPECT_THAT(five_vertices({{"mode", 6}}).triangles, ElementsAre(Triangle{1, 2, 0}, Triangle{2, 3, 0}, Triangle{3, 4, 0}));
}

TEST(GltfMesh, without_normals_it_is_faceted) { EXPECT_TRUE(five_vertices(Json::object()).normals.empty()); }

TEST(GltfMesh, all_index_types_give_equal_triangles) {
  for (const int type : {test::kUnsignedByte, test::kUnsignedShort, test::kUnsignedInt}) {
    GltfBuilder b;
    int indices = -1;
    if (type == test::kUnsignedByte) indices = b.add_accessor(std::vector<std::uint8_t>{2, 0, 1}, type, "SCALAR", 3);
    if (type == test::kUnsignedShort) indices = b.add_accessor(std::vector<std::uint16_t>{2, 0, 1}, type, "SCALAR", 3);
    if (type == test::kUnsignedInt) indices = b.add_accessor(std::vector<std::uint32_t>{2, 0, 1}, type, "SCALAR", 3);
    b.add_triangle({{"indices", indices}});
    EXPECT_THAT(parse_mesh(b).triangles, ElementsAre(Triangle{2, 0, 1})) << type;
  }
}

TEST(GltfMesh, index_beyond_the_vertices_is_an_error) {
  GltfBuilder b;
  b.add_triangle({{"indices", b.add_accessor(std::vector<std::uint16_t>{0, 1, 3})}});
  EXPECT_EQ(error_message([&] { parse_mesh(b); }), "a.glb: meshes[0].primitives[0]: index 2 is 3; accepted: 0 to 2");
}

TEST(GltfMesh, points_and_lines_give_one_warning) {
  GltfBuilder b;
  const int mesh = b.add_triangle({{"mode", 0}});
  b.root["meshes"][0]["primitives"].push_back(b.root["meshes"][0]["primitives"][0]);
  b.add_node({{"mesh", mesh}});
  std::vector<std::string> warnings;
  EXPECT_TRUE(parse(b, &warnings).instances.empty());
  EXPECT_THAT(warnings,
              ElementsAre("a.glb: points and lines are not supported: they are left out (first at meshes[0].primitives[0])"));
}

TEST(GltfMesh, missing_positions_are_a_warning) {
  GltfBuilder b;
  b.add_node({{"mesh", b.add_mesh({{"attributes", Json::object()}})}});
  std::vector<std::string> warnings;
  EXPECT_TRUE(parse(b, &warnings).shapes.empty());
  EXPECT_THAT(warnings, Contains("a.glb: primitives without positions are left out (first at meshes[0].primitives[0])"));
}

TEST(GltfMesh, two_nodes_share_a_shape) {
  GltfBuilder b;
  const int mesh = b.add_triangle();
  b.add_node({{"mesh", mesh}, {"name", "left"}});
  b.add_node({{"mesh", mesh}});
  const Scene scene = parse(b);
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.shapes.size(), 1u);
  EXPECT_EQ(scene.instances[0].name, "left");
  EXPECT_EQ(scene.instances[1].node, 1);
}

TEST(GltfAccessor, reads_interleaved_data) {
  GltfBuilder b;
  const int view = b.add_view(std::vector<float>{0, 0, 0, 0.1f, 0.2f, 1, 0, 0, 0.3f, 0.4f, 0, 1, 0, 0.5f, 0.6f});
  b.root["bufferViews"][0]["byteStride"] = 20;
  const Json accessor = {{"bufferView", view}, {"componentType", test::kFloat}, {"count", 3}};
  Json positions = accessor, uvs = accessor;
  positions["type"] = "VEC3";
  uvs["type"] = "VEC2", uvs["byteOffset"] = 12;
  b.add_mesh({{"attributes", {{"POSITION", b.add("accessors", positions)}, {"TEXCOORD_0", b.add("accessors", uvs)}}}});
  const Mesh mesh = parse_mesh(b);
  EXPECT_THAT(mesh.positions, ElementsAre(Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)));
  EXPECT_THAT(mesh.uvs, ElementsAre(Vec2f(0.1f, 0.2f), Vec2f(0.3f, 0.4f), Vec2f(0.5f, 0.6f)));
}

TEST(GltfAccessor, last_strided_element_needs_no_padding) {
  GltfBuilder b;
  // The buffer view has 44 bytes: two strides of 16 bytes, and 12 bytes for the last element.
  const int view = b.add_view(std::vector<float>{0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0});
  b.root["bufferViews"][0]["byteStride"] = 16;
  const int positions =
      b.add("accessors", {{"bufferView", view}, {"componentType", test::kFloat}, {"count", 3}, {"type", "VEC3"}});
  b.add_mesh({{"attributes", {{"POSITION", positions}}}});
  EXPECT_EQ(parse_mesh(b).positions.at(2), Vec3f(0, 1, 0));
}

template <class T>
std::vector<Vec2f> integer_uvs(const std::vector<T>& values, int component_type, bool normalized) {
  GltfBuilder b;
  const int view = b.add_view(values);
  b.root["bufferViews"][0]["byteStride"] = 4;
  const int uvs = b.add(
      "accessors",
      {{"bufferView", view}, {"componentType", component_type}, {"normalized", normalized}, {"count", 3}, {"type", "VEC2"}});
  b.add_triangle({{"attributes", {{"TEXCOORD_0", uvs}}}});
  return parse_mesh(b).uvs;
}

TEST(GltfAccessor, normalized_unsigned_bytes_are_divided_by_255) {
  EXPECT_THAT(integer_uvs<std::uint8_t>({0, 255, 9, 9, 51, 102, 9, 9, 255, 0}, 5121, true),
              ElementsAre(Vec2f(0.0f, 1.0f), Vec2f(0.2f, 0.4f), Vec2f(1.0f, 0.0f)));
}

TEST(GltfAccessor, normalized_shorts_are_clamped) {
  EXPECT_THAT(integer_uvs<std::int16_t>({0, 32767, -32767, -32768, 1, -1}, 5122, true),
              ElementsAre(Vec2f(0.0f, 1.0f), Vec2f(-1.0f, -1.0f), Vec2f(1.0f / 32767.0f, -1.0f / 32767.0f)));
}

TEST(GltfAccessor, plain_integers_keep_their_value) {
  EXPECT_THAT(integer_uvs<std::int8_t>({0, 1, 9, 9, -128, 127, 9, 9, 5, 6}, 5120, false),
              ElementsAre(Vec2f(0, 1), Vec2f(-128, 127), Vec2f(5, 6)));
}

TEST(GltfAccessor, sparse_values_replace_elements_of_a_base) {
  GltfBuilder b;
  b.add_triangle();
  const int indices = b.add_view(std::vector<std::uint8_t>{0, 2}),
            values = b.add_view(std::vector<Vec3f>{{7, 8, 9}, {4, 5, 6}});
  b.accessor(0)["sparse"] = {{"count", 2},
                             {"indices", {{"bufferView", indices}, {"componentType", test::kUnsignedByte}}},
                             {"values", {{"bufferView", values}}}};
  EXPECT_THAT(parse_mesh(b).positions, ElementsAre(Vec3f(7, 8, 9), Vec3f(1, 0, 0), Vec3f(4, 5, 6)));
}

TEST(GltfAccessor, sparse_values_without_a_base_replace_zeros) {
  GltfBuilder b;
  b.add_triangle();
  const int indices = b.add_view(std::vector<std::uint16_t>{1}), values = b.add_view(std::vector<Vec3f>{{7, 8, 9}});
  b.accessor(0)["sparse"] = {{"count", 1},
                             {"indices", {{"bufferView", indices}, {"componentType", test::kUnsignedShort}}},
                             {"values", {{"bufferView", values}}}};
  b.accessor(0).erase("bufferView");
  EXPECT_THAT(parse_mesh(b).positions, ElementsAre(Vec3f(0, 0, 0), Vec3f(7, 8, 9), Vec3f(0, 0, 0)));
}

TEST(GltfAccessor, sparse_index_beyond_accessor_is_an_error) {
  GltfBuilder b;
  b.add_triangle();
  const int indices = b.add_view(std::vector<std::uint16_t>{3}), values = b.add_view(std::vector<Vec3f>{{7, 8, 9}});
  b.accessor(0)["sparse"] = {{"count", 1},
                             {"indices", {{"bufferView", indices}, {"componentType", test::kUnsignedShort}}},
                             {"values", {{"bufferView", values}}}};
  EXPECT_EQ(error_message([&] { parse_mesh(b); }),
            "a.glb: accessors[0].sparse.indices: replaces element 3, but the number of elements is 3");
}

TEST(GltfAccessor, too_many_sparse_values_are_an_error) {
  GltfBuilder b;
  b.add_triangle();
  const int view = b.add_view(std::vector<std::uint16_t>{1});
  b.accessor(0)["sparse"] = {{"count", 4},
                             {"indices", {{"bufferView", view}, {"componentType", test::kUnsignedShort}}},
                             {"values", {{"bufferView", view}}}};
  EXPECT_EQ(error_message([&] { parse_mesh(b); }),
            "a.glb: accessors[0].sparse: replaces 4 elements, but the accessor has only 3");
}

TEST(GltfAccessor, huge_counts_do_not_allocate) {
  GltfBuilder b;
  b.add_triangle();
  b.accessor(0).erase("bufferView");
  b.accessor(0)["count"] = 2'000'000'000;
  EXPECT_THAT(error_message([&] { parse_mesh(b); }),
              StartsWith("a.glb: accessors[0]: the unpacked scene needs too much memory"));
}

TEST(GltfAccessor, infinite_position_is_an_error) {
  for (const float bad : {kNan, kInfinity}) {
    GltfBuilder b;
    b.add_mesh({{"attributes", {{"POSITION", b.add_accessor(std::vector<Vec3f>{{0, 0, 0}, {1, bad, 0}, {0, 1, 0}})}}}});
    EXPECT_EQ(error_message([&] { parse_mesh(b); }), "a.glb: accessors[0]: element 1 is not finite");
  }
}

TEST(GltfMesh, attribute_with_another_count_is_an_error) {
  GltfBuilder b;
  b.add_triangle({{"attributes", {{"NORMAL", b.add_accessor(std::vector<Vec3f>{{0, 0, 1}, {0, 0, 1}})}}}});
  EXPECT_EQ(error_message([&] { parse_mesh(b); }), "a.glb: meshes[0].primitives[0]: has 3 positions, but 2 values of NORMAL");
}

TEST(GltfMesh, normalises_tiny_and_huge_normals) {
  GltfBuilder b;
  b.add_triangle({{"attributes", {{"NORMAL", b.add_accessor(std::vector<Vec3f>{{0, 0, 2}, {0, 1e-30f, 0}, {3e38f, 0, 0}})}}}});
  EXPECT_THAT(parse_mesh(b).normals, ElementsAre(Vec3f(0, 0, 1), Vec3f(0, 1, 0), Vec3f(1, 0, 0)));
}

TEST(GltfMesh, zero_normals_come_from_triangles) {
  GltfBuilder b;
  b.add_triangle({{"attributes", {{"NORMAL", b.add_accessor(std::vector<Vec3f>{{1, 0, 0}, {0, 0, 0}, {1, 0, 0}})}}}});
  std::vector<std::string> warnings;
  EXPECT_THAT(parse_mesh(b, &warnings).normals, ElementsAre(Vec3f(1, 0, 0), Vec3f(0, 0, 1), Vec3f(1, 0, 0)));
  EXPECT_THAT(warnings,
              Contains("a.glb: zero-length normals are replaced by those of the triangles (first at meshes[0].primitives[0])"));
}

TEST(GltfMesh, vertex_colours_of_three_floats_are_read) {
  GltfBuilder b;
  b.add_triangle({{"attributes", {{"COLOR_0", b.add_accessor(std::vector<Vec3f>{{1, 0.5f, 0}, {0, 1, 0}, {0, 0, -1}})}}}});
  const Mesh mesh = parse_mesh(b);
  EXPECT_THAT(mesh.colors, ElementsAre(Vec3f(1, 0.5f, 0), Vec3f(0, 1, 0), Vec3f(0)));
  EXPECT_TRUE(mesh.alphas.empty());
}

TEST(GltfMesh, byte_colours_include_alpha) {
  GltfBuilder b;
  const int colors = b.add_accessor(std::vector<std::uint8_t>{255, 0, 51, 255, 0, 0, 0, 0, 255, 255, 255, 102},
                                    test::kUnsignedByte, "VEC4", 3);
  b.accessor(colors)["normalized"] = true;
  b.add_triangle({{"attributes", {{"COLOR_0", colors}}}});
  const Mesh mesh = parse_mesh(b);
  EXPECT_THAT(mesh.colors, ElementsAre(Vec3f(1, 0, 51.0f / 255.0f), Vec3f(0), Vec3f(1)));
  EXPECT_THAT(mesh.alphas, ElementsAre(1.0f, 0.0f, 102.0f / 255.0f));
}

TEST(GltfMesh, colours_that_change_nothing_are_left_out) {
  GltfBuilder b;
  b.add_triangle({{"attributes", {{"COLOR_0", b.add_accessor(std::vector<Vec4f>(3, Vec4f(1)))}}}});
  const Mesh mesh = parse_mesh(b);
  EXPECT_TRUE(mesh.colors.empty());
  EXPECT_TRUE(mesh.alphas.empty());
}

TEST(GltfMesh, colours_of_two_numbers_are_an_error) {
  GltfBuilder b;
  b.add_triangle({{"attributes", {{"COLOR_0", b.add_accessor(std::vector<Vec2f>(3))}}}});
  EXPECT_THAT(error_message([&] { parse_mesh(b); }), HasSubstr("has the wrong type for its use; accepted: VEC4"));
}

TEST(GltfMesh, reads_tangents_for_normal_maps) {
  GltfBuilder b;
  const int tangents = b.add_accessor(std::vector<Vec4f>{{2, 0, 0, 1}, {0, 3, 0, -0.5f}, {0, 0, 1e-30f, 1}});
  b.add_triangle({{"attributes", {{"TANGENT", tangents}}}, {"material", 0}});
  b.add("materials", Json::object());
  EXPECT_TRUE(parse_mesh(b).tangents.empty());
  b.add("images", {{"bufferView", b.add_view(test::white_png())}});
  b.add("textures", {{"source", 0}});
  b.root["materials"][0]["normalTexture"] = {{"index", 0}};
  EXPECT_THAT(parse_mesh(b).tangents, ElementsAre(Vec4f(1, 0, 0, 1), Vec4f(0, 1, 0, -1), Vec4f(0, 0, 1, 1)));
}

TEST(GltfMesh, node_extras_set_visibility_and_shadow) {
  const auto shown_by = [](const Json& extras) {
    GltfBuilder b;
    b.add_node({{"mesh", b.add_triangle()}, {"extras", extras}});
    return parse(b).instances.at(0);
  };
  EXPECT_TRUE(shown_by({{"visible_to_camera", 0}}).hidden_from_cameras);
  EXPECT_FALSE(shown_by({{"visible_to_camera", 0}}).casts_no_shadow);
  EXPECT_TRUE(shown_by({{"visible_to_camera", false}}).hidden_from_cameras);
  EXPECT_TRUE(shown_by({{"casts_shadow", false}}).casts_no_shadow);
  for (const Json& shown : {Json(1), Json(true), Json("0"), Json(nullptr)}) {
    EXPECT_FALSE(shown_by({{"visible_to_camera", shown}}).hidden_from_cameras) << shown;
    EXPECT_FALSE(shown_by({{"casts_shadow", shown}}).casts_no_shadow) << shown;
  }
  EXPECT_FALSE(shown_by("visible_to_camera").hidden_from_cameras);
}

TEST(GltfMesh, result_passes_validation) {
  GltfBuilder b;
  b.add_node({{"mesh", b.add_triangle()}});
  EXPECT_NO_THROW(validate(parse(b), "a.glb"));
}

}  // namespace
}  // namespace lippmann
