#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "lippmann/core/error.hpp"
#include "scene/gltf/gltf_builder.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::error_message;
using test::GltfBuilder;
using test::Json;
using test::parse;
using testing::Contains;
using testing::HasSubstr;

GltfBuilder good_document() {
  GltfBuilder b;
  b.add("materials", {{"pbrMetallicRoughness", {{"metallicFactor", 0.5}}}});
  const int indices = b.add_accessor(std::vector<std::uint16_t>{0, 1, 2, 0});
  b.accessor(indices)["count"] = 3;
  b.add_triangle({{"material", 0}, {"indices", indices}});
  b.add_node({{"mesh", 0}, {"children", {1}}});
  b.add_node({{"rotation", {0, 0, 0, 1}}});
  b.add("scenes", {{"nodes", {0}}});
  b.root["scene"] = 0;
  const int times = b.add_accessor(std::vector<float>{0.0f, 1.0f});
  const int values = b.add_accessor(std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}});
  b.add("animations", {{"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}},
                       {"samplers", {{{"input", times}, {"output", values}}}}});
  b.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}});
  return b;
}

/// Returns the error message of a document in which `value` replaces the value at `pointer`. A null removes the old
/// value.
std::string message_with(const std::string& pointer, const Json& value) {
  GltfBuilder b = good_document();
  Json root = b.document();
  const Json::json_pointer at(pointer);
  if (value.is_null())
    root.at(at.parent_pointer()).erase(at.back());
  else
    root[at] = value;
  return error_message([&] { parse(GltfBuilder::glb(root.dump(), b.binary)); });
}

TEST(GltfDocument, good_document_passes) { EXPECT_NO_THROW(parse(good_document())); }

struct Fault {
  const char* name;
  const char* pointer;
  Json value;
  const char* message;
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class GltfFault : public testing::TestWithParam<Fault> {};

TEST_P(GltfFault, is_an_error_that_names_the_element) {
  EXPECT_THAT(message_with(GetParam().pointer, GetParam().value), HasSubstr(std::string("a.glb: ") + GetParam().message));
}

const Fault kFaults[] = {
    {"no_version", "/asset/version", nullptr, "asset.version: is missing"},
    {"version_1", "/asset/version", "1.0", "asset.version: is '1.0'; accepted: 2.0"},
    {"newer_minor", "/asset/minVersion", "2.1", "asset.minVersion: is not 2.0"},
    {"array_expected", "/cameras", 3, "cameras: is not an array"},
    {"object_expected", "/nodes/0", 3, "nodes[0]: is not an object"},
    {"string_expected", "/nodes/0/name", 3, "nodes[0].name: is not a string"},
    {"number_expected", "/materials/0/pbrMetallicRoughness/metallicFactor", "x",
     "materials[0].pbrMetallicRoughness.metallicFactor: is not a number"},
    {"bool_expected", "/materials/0/doubleSided", 1, "materials[0].doubleSided: is not true or false"},
    {"integer_expected", "/scene", 0.5, "scene: is 0.5, not an integer"},
    {"negative_index", "/nodes/0/mesh", -1, "nodes[0].mesh: is -1"},
    {"factor_out_of_range", "/materials/0/pbrMetallicRoughness/metallicFactor", 2,
     "materials[0].pbrMetallicRoughness.metallicFactor: is 2; accepted: 0 to 1.001"},
    {"required_property", "/accessors/0/count", nullptr, "accessors[0].count: is missing"},
    {"wrong_length", "/nodes/1/rotation", {0, 0, 1}, "nodes[1].rotation: has 3 entries; accepted: 4"},
    {"unknown_choice", "/accessors/0/type", "VEC5", "accessors[0].type: is 'VEC5'; accepted: SCALAR, VEC2"},
    {"unknown_alpha_mode", "/materials/0/alphaMode", "OPAQUE|MASK", "materials[0].alphaMode: is 'OPAQUE|MASK'"},
    {"dangling_mesh", "/nodes/0/mesh", 1, "nodes[0].mesh: refers to meshes[1], but the number of meshes is 1"},
    {"dangling_attribute", "/meshes/0/primitives/0/attributes/POSITION", 9,
     "meshes[0].primitives[0].attributes.POSITION: refers to accessors[9], but the number of accessors is 4"},
    {"dangling_scene", "/scene", 1, "scene: refers to scenes[1]"},
    {"dangling_sampler", "/animations/0/channels/0/sampler", 1, "animations[0].channels[0]: refers to samplers[1]"},
    {"dangling_light",
     "/nodes/0/extensions",
     {{"KHR_lights_punctual", {{"light", 0}}}},
     "nodes[0].extensions.KHR_lights_punctual.light: refers to lights[0], but the number of lights is 0"},
    {"child_twice", "/nodes/0/children", {1, 1}, "nodes[0].children: lists 1 twice"},
    {"stride_not_of_4", "/bufferViews/0/byteStride", 6, "bufferViews[0].byteStride: is 6; accepted: multiples of 4"},
    {"component_type", "/accessors/0/componentType", 5124, "accessors[0]: has the component type 5124"},
    {"count_beyond_view", "/accessors/0/count", 5, "accessors[0]: 5 elements of 2 bytes"},
    {"count_beyond_its_view", "/accessors/1/count", 200'000'000, "accessors[1]: 200000000 elements of 12 bytes"},
    {"count_beyond_memory", "/accessors/1/count", 2147483647, "accessors[1]: the unpacked scene needs too much memory"},
    {"offset_beyond_view", "/accessors/0/byteOffset", 4, "accessors[0]: 3 elements of 2 bytes from byte 4 on"},
    {"offset_that_overflows", "/accessors/0/byteOffset", 9007199254740991, "accessors[0]: 3 elements of 2 bytes"},
    {"stride_below_element", "/bufferViews/1/byteStride", 8, "accessors[1]: has elements of 12 bytes with a stride of 8 bytes"},
    {"view_beyond_buffer", "/bufferViews/0/byteLength", 1000,
     "bufferViews[0]: 1000 bytes from byte 0 on lie outside buffers[0]"},
    {"view_offset_overflows", "/bufferViews/0/byteOffset", 9007199254740992, "bufferViews[0]: 8 bytes from byte"},
    {"buffer_beyond_chunk", "/buffers/0/byteLength", 9007199254740992, "buffers[0]: states 9007199254740992 bytes"},
    {"second_buffer_without_uri", "/buffers/1", {{"byteLength", 4}}, "buffers[1]: has no uri"},
    {"no_buffers", "/buffers", nullptr, "bufferViews[0].buffer: refers to buffers[0], but the number of buffers is 0"},
    {"data_uri_not_base64", "/buffers/0/uri", "data:application/octet-stream,AAAA", "buffers[0]: the data URI is not base64"},
    {"data_uri_bad_digit", "/buffers/0/uri", "data:;base64,A*AA", "buffers[0]: the data URI is not valid base64"},
    {"data_uri_too_short", "/buffers/0/uri", "data:;base64,AAAA", "buffers[0]: states 76 bytes, but 3 are available"},
    {"index_of_wrong_type", "/meshes/0/primitives/0/indices", 3,
     "accessors[3]: has the wrong type for its use; accepted: SCALAR"},
    {"float_indices", "/meshes/0/primitives/0/indices", 2, "accessors[2]: does not hold plain unsigned integers"},
    {"scalar_positions", "/meshes/0/primitives/0/attributes/POSITION", 2, "accessors[2]: has the wrong type for its use"},
    {"camera_type", "/cameras/0/type", "fisheye", "cameras[0].type: is 'fisheye'; accepted: perspective, orthographic"},
    {"camera_fov", "/cameras/0/perspective/yfov", 3.2, "cameras[0].perspective.yfov: is 3.2"},
    {"required_extension", "/extensionsRequired", Json::array({"MSFT_lod"}),
     "extensionsRequired: needs MSFT_lod, which is not supported: remove it from extensionsRequired; the nodes are then "
     "shown in full detail; accepted: EXT_lights_ies, EXT_"},
    {"extension_not_a_string", "/extensionsUsed", Json::array({3}), "extensionsUsed[0]: is not a string"},
};

INSTANTIATE_TEST_SUITE_P(GltfDocument, GltfFault, testing::ValuesIn(kFaults),
                         [](const auto& fault) { return std::string(fault.param.name); });

TEST(GltfDocument, messages_have_no_control_characters) {
  EXPECT_THAT(message_with("/materials/0/alphaMode", "\x1b[31mred\n"), HasSubstr("is '?[31mred?'"));
}

TEST(GltfDocument, integer_written_as_float_is_read) { EXPECT_THAT(message_with("/scene", 0.0), "(no Error)"); }

TEST(GltfDocument, unknown_extension_warns_once_with_objects) {
  GltfBuilder b = good_document();
  b.root["extensionsUsed"] = {"EXT_surprise"};
  b.root["materials"][0]["name"] = "Silk";
  b.root["materials"][0]["extensions"]["EXT_surprise"] = {{"thicknessFactor", 1}};
  std::vector<std::string> warnings;
  parse(b, &warnings);
  EXPECT_EQ(std::count(warnings.begin(), warnings.end(),
                       "a.glb: the extension EXT_surprise is not supported and is ignored (materials[0] 'Silk')"),
            1);
}

TEST(GltfDocument, unlisted_extension_is_a_warning) {
  GltfBuilder b = good_document();
  b.root["materials"][0]["extensions"]["EXT_surprise"] = Json::object();
  std::vector<std::string> warnings;
  parse(b, &warnings);
  EXPECT_THAT(warnings, Contains("a.glb: the extension EXT_surprise is not supported and is ignored (materials[0])"));
}

TEST(GltfDocument, warning_names_the_first_objects) {
  GltfBuilder b = good_document();
  for (int i = 0; i < 6; ++i) b.add("materials", {{"extensions", {{"EXT_surprise", Json::object()}}}});
  std::vector<std::string> warnings;
  parse(b, &warnings);
  EXPECT_THAT(warnings, Contains(HasSubstr("(materials[1], materials[2], materials[3], materials[4] and 2 more)")));
}

TEST(GltfDocument, asset_description_is_no_warning) {
  GltfBuilder b = good_document();
  b.root["extensionsUsed"] = {"KHR_xmp", "KHR_xmp_json_ld"};
  b.root["extensionsRequired"] = {"KHR_xmp_json_ld"};
  std::vector<std::string> warnings;
  parse(b, &warnings);
  EXPECT_THAT(warnings, testing::Each(testing::Not(HasSubstr("xmp"))));
}

std::string message_requiring(const char* extension) { return message_with("/extensionsRequired", Json::array({extension})); }

TEST(GltfDocument, required_extensions_are_rejected_with_advice) {
  EXPECT_THAT(message_requiring("KHR_texture_basisu"),
              HasSubstr("not supported: convert to PNG first, with gltf-transform ktxdecompress IN OUT"));
  EXPECT_THAT(message_requiring("EXT_texture_avif"), HasSubstr("gltf-transform webp IN OUT"));
  EXPECT_THAT(message_requiring("KHR_meshopt_compression"), HasSubstr("gltfpack -i IN -o OUT -noq -kn -km -ke"));
  EXPECT_THAT(message_requiring("KHR_lights_image_based"), HasSubstr("a panorama with `environment`"));
  EXPECT_THAT(message_requiring("KHR_animation_pointer"), HasSubstr("its animations are then ignored"));
}

TEST(GltfDocument, unknown_required_extension_gets_general_advice) {
  EXPECT_THAT(message_requiring("ACME_jelly"),
              HasSubstr("needs ACME_jelly, which is not supported: export it again without it, or remove it from "
                        "extensionsRequired; it is then ignored with a warning; accepted: "));
}

TEST(GltfDocument, after_50_warnings_there_is_one_more) {
  GltfBuilder b = good_document();
  for (int i = 0; i < 1000; ++i) b.root["extensionsUsed"].push_back("EXT_" + std::to_string(i));
  std::vector<std::string> warnings;
  parse(b, &warnings);
  ASSERT_EQ(warnings.size(), 51u);
  EXPECT_EQ(warnings.back(), "a.glb: further warnings are left out");
}

TEST(GltfDocument, required_extension_that_is_read_passes) {
  EXPECT_EQ(message_with("/extensionsRequired", Json::array({"KHR_materials_unlit"})), "(no Error)");
}

TEST(GltfDocument, unpacking_beyond_the_limit_is_an_error) {
  GltfLimits limits;
  limits.unpacked_bytes = 30;  // three positions need 36 bytes
  EXPECT_THAT(error_message([&] { parse(good_document(), nullptr, limits); }),
              HasSubstr("accessors[1]: the unpacked scene needs too much memory; accepted: at most 30 bytes in total"));
}

/// The first mesh is invalid, and all meshes together exceed the memory limit. The limit must be checked before any
/// mesh is unpacked, so the error must be about the limit.
TEST(GltfDocument, counts_all_meshes_before_unpacking) {
  GltfBuilder b;
  const int bad = b.add_accessor(std::vector<Vec3f>{{0, 0, 0}, {std::nanf(""), 0, 0}, {0, 1, 0}});
  b.add_node({{"mesh", b.add_mesh({{"attributes", {{"POSITION", bad}}}})}});
  b.add_node({{"mesh", b.add_triangle()}});
  b.accessor(1).erase("bufferView");
  b.accessor(1)["count"] = 1'000'000'000;
  EXPECT_THAT(error_message([&] { parse(b); }), HasSubstr("accessors[1]: the unpacked scene needs too much memory"));
}

TEST(GltfDocument, keys_are_counted_before_meshes_are_unpacked) {
  GltfBuilder b = good_document();
  b.binary.at(8) = std::byte{0xff}, b.binary.at(10) = std::byte{0xff}, b.binary.at(11) = std::byte{0xff};
  for (const int accessor : {2, 3}) b.accessor(accessor).erase("bufferView"), b.accessor(accessor)["count"] = 2'000'000'000;
  EXPECT_THAT(error_message([&] { parse(b); }), HasSubstr("the unpacked scene needs too much memory"));
}

TEST(GltfDocument, instances_beyond_the_limit_are_an_error) {
  GltfBuilder b;
  const int mesh = b.add_triangle();
  for (int i = 0; i < 100; ++i) b.add_node({{"mesh", mesh}});
  GltfLimits limits;
  limits.unpacked_bytes = 100 * sizeof(Instance);  // enough for all instances, but the mesh needs memory too
  EXPECT_THAT(error_message([&] { parse(b, nullptr, limits); }), HasSubstr("too much memory"));
}

class GltfFolder : public testing::Test {
 protected:
  GltfFolder() {
    std::filesystem::create_directories(scene_ / "data");
    write(scene_ / "data/my bytes.bin");
    write(root_ / "secret.bin");
  }

  void write(const std::filesystem::path& path) const {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(triangle_.binary.data()), static_cast<std::streamsize>(triangle_.binary.size()));
  }

  std::string message_with_uri(const std::string& uri) const {
    Json root = triangle_.document();
    root["buffers"][0]["uri"] = uri;
    return error_message([&] { parse_gltf(test::contents_of(root.dump()), scene_ / "a.gltf", {}, Context{}); });
  }

  static GltfBuilder one_triangle() {
    GltfBuilder builder;
    builder.add_node({{"mesh", builder.add_triangle()}});
    return builder;
  }

  test::TempDir root_;
  std::filesystem::path scene_ = root_ / "scene";
  GltfBuilder triangle_ = one_triangle();
};

TEST_F(GltfFolder, decodes_percent_encoded_names) { EXPECT_EQ(message_with_uri("data/my%20bytes.bin"), "(no Error)"); }

TEST_F(GltfFolder, missing_file_is_an_error) {
  EXPECT_THAT(message_with_uri("none.bin"), HasSubstr("buffers[0]: 'none.bin' does not exist"));
}

TEST_F(GltfFolder, file_shorter_than_promised_is_an_error) {
  std::ofstream(scene_ / "short.bin") << "abc";
  EXPECT_THAT(message_with_uri("short.bin"), HasSubstr("buffers[0]: states 36 bytes, but 3 are available"));
}

TEST_F(GltfFolder, file_above_the_scene_is_refused) {
  EXPECT_THAT(message_with_uri("../secret.bin"), HasSubstr("buffers[0]: '../secret.bin' is outside the scene's folder"));
}

TEST_F(GltfFolder, encoded_dots_are_refused) {
  EXPECT_THAT(message_with_uri("data/%2e%2e/../%2E./secret.bin"), HasSubstr("is outside the scene's folder"));
}

TEST_F(GltfFolder, absolute_path_is_refused) {
  EXPECT_THAT(message_with_uri((root_ / "secret.bin").string()), HasSubstr("secret.bin' is outside the scene's folder"));
}

TEST_F(GltfFolder, web_address_is_refused) {
  EXPECT_THAT(message_with_uri("https://example.org/a.bin"),
              HasSubstr("buffers[0]: 'https://example.org/a.bin' is a network address"));
}

TEST_F(GltfFolder, link_that_leads_out_is_refused) {
  std::filesystem::create_symlink(root_ / "secret.bin", scene_ / "link.bin");
  EXPECT_THAT(message_with_uri("link.bin"), HasSubstr("buffers[0]: 'link.bin' is outside the scene's folder"));
}

TEST_F(GltfFolder, linked_folder_that_leads_out_is_refused) {
  std::filesystem::create_directory_symlink(root_.path(), scene_ / "up");
  EXPECT_THAT(message_with_uri("up/secret.bin"), HasSubstr("buffers[0]: 'up/secret.bin' is outside the scene's folder"));
}

TEST_F(GltfFolder, link_that_stays_inside_is_followed) {
  std::filesystem::create_symlink("data/my bytes.bin", scene_ / "link.bin");
  EXPECT_EQ(message_with_uri("link.bin"), "(no Error)");
}

TEST_F(GltfFolder, rejects_a_folder_as_file) {
  EXPECT_THAT(message_with_uri("data"), HasSubstr("buffers[0]: 'data' is not a regular file"));
}

TEST_F(GltfFolder, name_with_a_zero_byte_is_refused) {
  EXPECT_THAT(message_with_uri("data/my%20bytes.bin%00.png"), HasSubstr("is outside the scene's folder"));
}

}  // namespace
}  // namespace lippmann
