#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <functional>

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
using testing::ElementsAre;
using testing::HasSubstr;

using Packed = std::vector<unsigned char>;
using Triangle = std::array<std::uint32_t, 3>;

bool is_valid_or_says_why(const test::Contents& file) {
  Scene scene;
  try {
    scene = parse(file);
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("a.glb: "));
    return false;
  }
  EXPECT_NO_THROW(validate(scene, "a.glb"));
  return true;
}

Packed pack_vertices(const void* values, std::size_t count, std::size_t stride) {
  Packed packed(meshopt_encodeVertexBufferBound(count, stride));
  packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), values, count, stride));
  return packed;
}

/// Compresses a buffer view, which then refers to buffer 1. This buffer stands for an uncompressed copy, and has no
/// data.
void pack_view(GltfBuilder& b, int view, const Packed& packed, std::size_t count, std::size_t stride, const char* mode,
               const char* filter = "NONE") {
  const int source = b.add_view(packed);
  Json& target = b.root["bufferViews"][static_cast<std::size_t>(view)];
  const Json from = b.root["bufferViews"][static_cast<std::size_t>(source)];
  target = {{"buffer", 1}, {"byteLength", count * stride}};
  target["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                     {"byteOffset", from["byteOffset"]},
                                                     {"byteLength", from["byteLength"]},
                                                     {"byteStride", stride},
                                                     {"count", count},
                                                     {"mode", mode},
                                                     {"filter", filter}};
}

test::Contents with_fallback(const GltfBuilder& b) {
  Json root = b.document();
  root["buffers"].push_back({{"byteLength", 1'000'000}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
  root["extensionsRequired"] = {"EXT_meshopt_compression"};
  return GltfBuilder::glb(root.dump(), b.binary);
}

const std::vector<Vec3f> kCorners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5f}};

/// Two compressed triangles: accessor 0 has the positions, accessor 1 the indices, compressed in `index_mode`.
GltfBuilder packed_square(const char* index_mode) {
  const std::vector<std::uint32_t> corners{0, 1, 2, 2, 1, 3};
  GltfBuilder b;
  const int positions = b.add_accessor(kCorners);
  const int indices = b.add_accessor(std::vector<std::uint16_t>(corners.begin(), corners.end()));
  b.add_node({{"mesh", b.add_mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}})}});
  Packed packed(1000);
  packed.resize(std::string_view(index_mode) == "TRIANGLES"
                    ? meshopt_encodeIndexBuffer(packed.data(), packed.size(), corners.data(), corners.size())
                    : meshopt_encodeIndexSequence(packed.data(), packed.size(), corners.data(), corners.size()));
  pack_view(b, 0, pack_vertices(kCorners.data(), kCorners.size(), sizeof(Vec3f)), 4, sizeof(Vec3f), "ATTRIBUTES");
  pack_view(b, 1, packed, corners.size(), 2, index_mode);
  return b;
}

Mesh mesh_of(const test::Contents& contents) {
  const Scene scene = parse(contents);
  validate(scene, "a.glb");
  return std::get<Mesh>(scene.shapes.at(0));
}

TEST(GltfMeshopt, vertices_and_triangles_round_trip) {
  const Mesh mesh = mesh_of(with_fallback(packed_square("TRIANGLES")));
  EXPECT_EQ(mesh.positions, kCorners);
  // The codec may rotate the corners of a triangle but not reverse their order.
  for (std::size_t t = 0; t < 2; ++t) {
    Triangle turned = mesh.triangles.at(t);
    std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
    EXPECT_EQ(turned, (t == 0 ? Triangle{0, 1, 2} : Triangle{1, 3, 2}));
  }
}

/// The first view is invalid, and all views together exceed the memory limit. The limit must be checked before any view
/// is unpacked, so the error must be about the limit.
TEST(GltfMeshopt, counts_all_views_before_unpacking) {
  GltfBuilder b = packed_square("TRIANGLES");
  const std::size_t from = b.root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["byteOffset"];
  b.binary.at(from) = std::byte{0xee};
  GltfLimits limits;
  limits.unpacked_bytes = 4 * sizeof(Vec3f);
  EXPECT_THAT(error_message([&] { parse(with_fallback(b)); }), HasSubstr("bufferViews[0].extensions"));
  EXPECT_THAT(error_message([&] { parse(with_fallback(b), nullptr, limits); }),
              HasSubstr("bufferViews[1]: the unpacked scene needs too much memory"));
}

TEST(GltfMeshopt, index_sequence_round_trips) {
  EXPECT_THAT(mesh_of(with_fallback(packed_square("INDICES"))).triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 3}));
}

TEST(GltfMeshopt, octahedral_normals_are_unfolded) {
  GltfBuilder b;
  const std::vector<Vec4f> directions{{1, 0, 0, 0}, {0, 0, -1, 0}, {0.6f, 0, 0.8f, 0}};
  std::vector<std::int8_t> filtered(12);
  meshopt_encodeFilterOct(filtered.data(), 3, 4, 8, &directions[0].x);
  const int normals = b.add_accessor(filtered, 5120, "VEC3", 3);
  b.accessor(normals)["normalized"] = true;
  b.add_node({{"mesh", b.add_triangle({{"attributes", {{"NORMAL", normals}}}})}});
  pack_view(b, 0, pack_vertices(filtered.data(), 3, 4), 3, 4, "ATTRIBUTES", "OCTAHEDRAL");
  b.root["bufferViews"][0]["byteStride"] = 4;
  const Mesh mesh = mesh_of(with_fallback(b));
  for (std::size_t i = 0; i < 3; ++i)
    // components of 8 bits have steps of 1/127
    EXPECT_LE(glm::length(mesh.normals.at(i) - Vec3f(directions[i])), 0.02f);
}

TEST(GltfMeshopt, exponential_numbers_are_expanded) {
  GltfBuilder b;
  std::vector<std::uint32_t> filtered(9);
  const std::vector<Vec3f> corners{{0, 0, 0}, {1024, 0, 0}, {0, 0.5f, 0}};
#if MESHOPTIMIZER_VERSION >= 190
  meshopt_encodeFilterExp(filtered.data(), 3, 12, 15, &corners[0].x, meshopt_EncodeExpSharedVector);
#else
  meshopt_encodeFilterExp(filtered.data(), 3, 12, 15, &corners[0].x);
#endif
  b.add_node({{"mesh", b.add_triangle()}});
  pack_view(b, 0, pack_vertices(filtered.data(), 3, 12), 3, 12, "ATTRIBUTES", "EXPONENTIAL");
  EXPECT_EQ(mesh_of(with_fallback(b)).positions, corners);  // powers of two are exact with any number of mantissa bits
}

TEST(GltfMeshopt, quaternions_are_completed) {
  GltfBuilder b;
  const Vec4f half(0.5f);
  std::vector<std::int16_t> filtered(8);
  const std::vector<Vec4f> rotations{{0, 0, 0, 1}, half};
  meshopt_encodeFilterQuat(filtered.data(), 2, 8, 16, &rotations[0].x);
  const int output = b.add_accessor(filtered, 5122, "VEC4", 2);
  b.accessor(output)["normalized"] = true;
  const int times = b.add_accessor(std::vector<float>{0, 1});
  b.add_node(Json::object());
  b.add("animations", {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}},
                       {"samplers", {{{"input", times}, {"output", output}}}}});
  pack_view(b, 0, pack_vertices(filtered.data(), 2, 8), 2, 8, "ATTRIBUTES", "QUATERNION");
  const Scene scene = parse(with_fallback(b));
  const Quatf q = scene.timeline.animations.at(0).rotation.values.at(1);
  EXPECT_NEAR(std::abs(q.w * 0.5f + q.x * 0.5f + q.y * 0.5f + q.z * 0.5f), 1.0f, 1e-4f);  // 16 bits per component
}

struct MeshoptFault {
  const char* name;
  std::function<void(Json&)> spoil;
  const char* message;
};
void PrintTo(const MeshoptFault& fault, std::ostream* out) { *out << fault.name; }

class GltfMeshoptFault : public testing::TestWithParam<MeshoptFault> {};

TEST_P(GltfMeshoptFault, is_an_error_that_names_the_view) {
  GltfBuilder b = packed_square("INDICES");
  GetParam().spoil(b.root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]);
  const std::string message = error_message([&] { parse(with_fallback(b)); });
  EXPECT_THAT(message, HasSubstr("a.glb: bufferViews[0].extensions.EXT_meshopt_compression"));
  EXPECT_THAT(message, HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    All, GltfMeshoptFault,
    testing::Values(MeshoptFault{"truncated", [](Json& e) { e["byteLength"] = e["byteLength"].get<int>() - 5; },
                                 "cannot be decoded as"},
                    MeshoptFault{"outside", [](Json& e) { e["byteOffset"] = 100'000; }, "lie outside buffers[0]"},
                    MeshoptFault{"no_buffer", [](Json& e) { e["buffer"] = 2; }, "refers to buffers[2]"},
                    MeshoptFault{"bomb", [](Json& e) { e["count"] = 2'000'000'000; }, "cannot hold 2000000000 elements in"},
                    MeshoptFault{"stride", [](Json& e) { e["byteStride"] = 6; }, "ATTRIBUTES cannot have elements of 6 bytes"},
                    MeshoptFault{"wide", [](Json& e) { e["byteStride"] = 260; }, "is 260; accepted: 1 to 256"},
                    MeshoptFault{"mode", [](Json& e) { e["mode"] = "SQUARES"; }, "is 'SQUARES'"},
                    MeshoptFault{"index_stride", [](Json& e) { e["mode"] = "INDICES"; }, "INDICES cannot have elements of "},
                    MeshoptFault{"filter", [](Json& e) { e["filter"] = "OCTAHEDRAL"; }, "OCTAHEDRAL cannot have elements of "},
                    MeshoptFault{"other_codec", [](Json& e) { e["mode"] = "TRIANGLES", e["byteStride"] = 4, e["count"] = 12; },
                                 "cannot be decoded as"}),
    [](const auto& fault) { return std::string(fault.param.name); });

TEST(GltfMeshopt, unpacked_fallback_view_is_an_error) {
  GltfBuilder b = packed_square("INDICES");
  b.root["bufferViews"][0].erase("extensions");
  EXPECT_THAT(error_message([&] { parse(with_fallback(b)); }), HasSubstr("lie outside buffers[1], which has 0 bytes"));
}

TEST(GltfMeshopt, flipped_bytes_are_valid_or_an_error) {
  int errors = 0;
  const test::Contents good = with_fallback(packed_square("TRIANGLES"));
  for (std::size_t i = good.size() - 100; i < good.size(); ++i)
    for (const std::byte flip : {std::byte{1}, std::byte{0x80}, std::byte{0xff}}) {
      test::Contents damaged = good;
      damaged[i] ^= flip;
      errors += is_valid_or_says_why(damaged) ? 0 : 1;
    }
  EXPECT_GT(errors, 0);
}

Packed draco_square(int method) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(2);
  const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const auto corner = [](std::size_t i) { return &kCorners[i].x; };
  builder.SetAttributeValuesForFace(positions, draco::FaceIndex(0), corner(0), corner(1), corner(2));
  builder.SetAttributeValuesForFace(positions, draco::FaceIndex(1), corner(2), corner(1), corner(3));
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  return {buffer.data(), buffer.data() + buffer.size()};
}

GltfBuilder draco_file(const Packed& packed, int index_type = test::kUnsignedShort) {
  GltfBuilder b;
  const int view = b.add_view(packed);
  const int positions = b.add("accessors", {{"componentType", test::kFloat}, {"type", "VEC3"}, {"count", 4}});
  const int indices = b.add("accessors", {{"componentType", index_type}, {"type", "SCALAR"}, {"count", 6}});
  const Json extension = {{"bufferView", view}, {"attributes", {{"POSITION", 0}}}};
  b.add_node({{"mesh", b.add_mesh({{"attributes", {{"POSITION", positions}}},
                                   {"indices", indices},
                                   {"extensions", {{"KHR_draco_mesh_compression", extension}}}})}});
  b.root["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return b;
}

/// Returns the corners of all triangles in a canonical order. Each triangle starts at its smallest corner.
std::vector<std::array<Vec3f, 3>> shape_of(const Mesh& mesh) {
  const auto less = [](Vec3f a, Vec3f b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
  std::vector<std::array<Vec3f, 3>> shape;
  for (const Triangle& t : mesh.triangles) {
    std::array<Vec3f, 3> corners{mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), less), corners.end());
    shape.push_back(corners);
  }
  std::sort(shape.begin(), shape.end(), [&](const auto& a, const auto& b) { return less(a[0], b[0]); });
  return shape;
}

TEST(GltfDraco, both_methods_restore_the_triangles) {
  Mesh expected;
  expected.positions = kCorners;
  expected.triangles = {{0, 1, 2}, {2, 1, 3}};
  for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING})
    for (const int type : {test::kUnsignedByte, test::kUnsignedShort, test::kUnsignedInt}) {
      const Scene scene = parse(draco_file(draco_square(method), type));
      validate(scene, "a.glb");
      EXPECT_EQ(shape_of(std::get<Mesh>(scene.shapes.at(0))), shape_of(expected));
    }
}

TEST(GltfDraco, primitives_may_share_a_stream) {
  GltfBuilder b = draco_file(draco_square(draco::MESH_EDGEBREAKER_ENCODING));
  b.root["meshes"][0]["primitives"].push_back(b.root["meshes"][0]["primitives"][0]);
  EXPECT_EQ(parse(b).shapes.size(), 2u);
}

std::string draco_message(const std::function<void(GltfBuilder&)>& spoil) {
  GltfBuilder b = draco_file(draco_square(draco::MESH_SEQUENTIAL_ENCODING));
  spoil(b);
  return error_message([&] { parse(b); });
}

TEST(GltfDraco, mismatch_with_accessors_is_an_error) {
  EXPECT_THAT(draco_message([](GltfBuilder& b) { b.accessor(0)["count"] = 5; }),
              HasSubstr("the Draco data has 4 elements for accessors[0], which has 5"));
  EXPECT_THAT(draco_message([](GltfBuilder& b) { b.accessor(0)["count"] = 3; }),
              HasSubstr("the Draco data has 2 triangles and 4 vertices, but the accessors have 2 and 3"));
  EXPECT_THAT(draco_message([](GltfBuilder& b) { b.accessor(1)["count"] = 3; }), HasSubstr("the accessors have 1 and 4"));
  EXPECT_THAT(draco_message([](GltfBuilder& b) { b.accessor(0)["type"] = "VEC2"; }),
              HasSubstr("another type or count than accessors[0]"));
  EXPECT_THAT(draco_message([](GltfBuilder& b) { b.accessor(1)["componentType"] = test::kFloat; }),
              HasSubstr("indices do not fit their accessor"));
}

Json& extension_of(GltfBuilder& b) { return b.root["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]; }

TEST(GltfDraco, missing_attributes_are_an_error) {
  EXPECT_THAT(draco_message([](GltfBuilder& b) { extension_of(b)["attributes"]["POSITION"] = 7; }),
              HasSubstr("the Draco data has no attribute 7"));
  EXPECT_THAT(draco_message([](GltfBuilder& b) { extension_of(b)["attributes"]["NORMAL"] = 0; }),
              HasSubstr("lacks the attribute 'NORMAL'"));
}

TEST(GltfDraco, strips_and_unindexed_triangles_are_an_error) {
  EXPECT_THAT(draco_message([](GltfBuilder& b) { b.root["meshes"][0]["primitives"][0]["mode"] = 5; }),
              HasSubstr("not an indexed triangle list"));
  EXPECT_THAT(draco_message([](GltfBuilder& b) { b.root["meshes"][0]["primitives"][0].erase("indices"); }),
              HasSubstr("not an indexed triangle list"));
}

TEST(GltfDraco, every_proper_prefix_is_an_error) {
  for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    const Packed whole = draco_square(method);
    for (std::size_t length = 1; length < whole.size(); ++length) {
      const Packed cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
      EXPECT_THAT(error_message([&] { parse(draco_file(cut)); }), HasSubstr("meshes[0].primitives[0]: ")) << length;
    }
  }
}

TEST(GltfDraco, flipped_bytes_are_valid_or_an_error) {
  for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    const Packed whole = draco_square(method);
    int errors = 0;
    for (std::size_t i = 0; i < whole.size(); ++i)
      for (const int flip : {1, 0x80, 0xff}) {
        Packed damaged = whole;
        damaged[i] = static_cast<unsigned char>(damaged[i] ^ flip);
        errors += is_valid_or_says_why(draco_file(damaged).glb()) ? 0 : 1;
      }
    EXPECT_GT(errors, 0) << method;
  }
}

}  // namespace
}  // namespace lippmann
