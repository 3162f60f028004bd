#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/gltf/gltf_builder.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::Contents;
using test::contents_of;
using test::error_message;
using test::GltfBuilder;
using test::parse;
using testing::HasSubstr;
using testing::StartsWith;

GltfBuilder one_triangle() {
  GltfBuilder builder;
  builder.add_node({{"mesh", builder.add_triangle()}});
  return builder;
}

std::string message_of(const Contents& contents) {
  return error_message([&] { parse(contents); });
}

void set_word(Contents& contents, std::size_t offset, std::uint32_t word) {
  for (std::size_t i = 0; i < 4; ++i) contents[offset + i] = static_cast<std::byte>(word >> (8 * i));
}

TEST(GltfContainer, glb_and_data_uri_give_equal_scenes) {
  const GltfBuilder builder = one_triangle();
  test::Json root = builder.document();
  // The data URI has the nine floats 0 0 0, 1 0 0, 0 1 0.
  root["buffers"][0]["uri"] = "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
  const Scene from_json = parse(contents_of(root.dump()));
  const Scene from_glb = parse(builder);
  EXPECT_EQ(std::get<Mesh>(from_json.shapes.at(0)).positions, std::get<Mesh>(from_glb.shapes.at(0)).positions);
  EXPECT_EQ(std::get<Mesh>(from_json.shapes.at(0)).positions[1], Vec3f(1, 0, 0));
}

TEST(GltfContainer, every_glb_prefix_is_an_error) {
  const Contents whole = one_triangle().glb();
  ASSERT_NO_THROW(parse(whole));
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_THAT(message_of({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)}), StartsWith("a.glb: "))
        << "cut to " << length << " bytes of " << whole.size();
}

TEST(GltfContainer, glb_of_version_1_is_refused) {
  Contents contents = one_triangle().glb();
  set_word(contents, 4, 1);
  EXPECT_EQ(message_of(contents), "a.glb: is a .glb of version 1; accepted: version 2");
}

TEST(GltfContainer, chunk_longer_than_the_file_is_refused) {
  Contents contents = one_triangle().glb();
  set_word(contents, 12, 0xffff'fff0);
  EXPECT_THAT(message_of(contents), StartsWith("a.glb: chunk[0]: states 4294967280 bytes"));
}

TEST(GltfContainer, first_chunk_other_than_json_is_refused) {
  Contents contents = one_triangle().glb();
  set_word(contents, 16, 0x004e4942);
  EXPECT_THAT(message_of(contents), StartsWith("a.glb: chunk[0]: is not JSON, as the first chunk"));
}

TEST(GltfContainer, bytes_after_the_end_are_a_warning) {
  Contents contents = one_triangle().glb();
  contents.resize(contents.size() + 3);
  std::vector<std::string> warnings;
  parse(contents, &warnings);
  EXPECT_THAT(warnings, testing::Contains("a.glb: 3 bytes after the end of the glTF data are ignored"));
}

TEST(GltfContainer, malformed_json_reports_line_and_column) {
  EXPECT_EQ(message_of(contents_of("{\n  \"asset\": ]\n}")), "a.glb: is neither a .glb nor valid JSON: line 2, column 12");
}

TEST(GltfContainer, json_that_ends_early_is_an_error) {
  EXPECT_THAT(message_of(contents_of("{\"asset\": {")), HasSubstr("nor valid JSON"));
}

TEST(GltfContainer, json_other_than_object_is_an_error) {
  EXPECT_EQ(message_of(contents_of("[1, 2]")), "a.glb: the JSON is not an object");
}

TEST(GltfContainer, number_beyond_double_is_an_error) {
  EXPECT_EQ(message_of(contents_of("{\"scene\": 0,\n  \"scale\": [1, 1e999]}")),
            "a.glb: the JSON has a number that is too large: '1e999' of 'scale' (line 2, column 16)");
}

TEST(GltfContainer, deep_nesting_is_an_error) {
  const std::string deep = "{\"extras\": " + std::string(100'000, '[') + std::string(100'000, ']') + "}";
  EXPECT_THAT(message_of(contents_of(deep)), HasSubstr("nested too deeply; accepted: at most 64 levels"));
}

TEST(GltfContainer, too_many_values_are_an_error) {
  GltfLimits limits;
  limits.json_values = 4;
  const Contents contents = contents_of(R"({"asset": {"version": "2.0"}, "extras": [0, 1, 2, 3]})");
  EXPECT_THAT(error_message([&] { parse(contents, nullptr, limits); }), HasSubstr("too many values; accepted: at most 4"));
}

TEST(GltfContainer, too_many_objects_are_an_error) {
  GltfLimits limits;
  limits.json_objects = 3;
  const Contents contents = contents_of(R"({"asset": {"version": "2.0"}, "nodes": [{}, {}]})");
  EXPECT_THAT(error_message([&] { parse(contents, nullptr, limits); }), HasSubstr("too many objects; accepted: at most 3"));
}

TEST(GltfContainer, missing_file_is_an_error) {
  EXPECT_EQ(error_message([] { load_gltf("/nowhere/a.glb", {}, Context{}); }), "/nowhere/a.glb: the file does not exist");
}

TEST(GltfContainer, file_beyond_the_limit_is_not_read) {
  const test::TempDir folder;
  std::ofstream(folder / "a.gltf") << std::string(100, ' ');
  GltfLimits limits;
  limits.file_bytes = 99;
  EXPECT_THAT(error_message([&] { load_gltf(folder / "a.gltf", {}, Context{}, limits); }),
              HasSubstr("the file has 100 bytes; accepted: at most 99 bytes"));
}

TEST(GltfContainer, load_scene_reads_glb_at_30_fps) {
  const test::TempDir folder;
  const Contents contents = one_triangle().glb();
  std::ofstream(folder / "box.glb", std::ios::binary)
      .write(reinterpret_cast<const char*>(contents.data()), static_cast<std::streamsize>(contents.size()));
  const Scene scene = load_scene((folder / "box.glb").string(), {}, Context{});
  EXPECT_EQ(scene.name, "box");
  EXPECT_EQ(scene.instances.size(), 1u);
  EXPECT_EQ(scene.timeline.frames_per_second, 30.0);
}

TEST(GltfContainer, frame_rate_below_zero_is_wrong_usage) {
  EXPECT_EQ(error_message([] { parse_gltf({}, "a.glb", {.frames_per_second = -1.0}, Context{}); }),
            "frames per second: is -1; accepted: a number above 0, or 0 for the rate of the keyframes");
}

}  // namespace
}  // namespace lippmann
