#include "scene/ply.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

#include "image/png.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using ::testing::HasSubstr;

Scene ply_scene(const std::string& text) {
  Scene scene = parse_ply("a.ply", text, Context{});
  validate(scene, "a.ply");
  return scene;
}

const Mesh& mesh(const Scene& scene) { return std::get<Mesh>(scene.shapes.at(0)); }

std::string ply_error(const std::string& text) {
  return test::error_message([&] { ply_scene(text); });
}

std::string header(const std::string& format, const std::string& more = {}) {
  return "ply\nformat " + format +
         " 1.0\ncomment a triangle\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" + more +
         "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
}

/// The vertices (0, 0, 0), (2, 0, 0), (0, 2, 0) and their face. The float 2 has the bytes 40 00 00 00.
std::string binary_triangle(bool big_endian) {
  std::string bytes;
  const auto add = [&](std::string value) {
    if (!big_endian) std::reverse(value.begin(), value.end());
    bytes += value;
  };
  const std::string zero(4, '\0'), two = std::string("\x40") + std::string(3, '\0');
  for (const std::string& coordinate : {zero, zero, zero, two, zero, zero, zero, two, zero}) add(coordinate);
  bytes += '\3';
  for (const char index : {0, 1, 2}) add(std::string(3, '\0') + index);
  return bytes;
}

TEST(Ply, compressed_splats_are_rejected_with_advice) {
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement vertex 1\nproperty uint packed_position\nproperty uint packed_color\n"
                      "end_header\n0 0\n"),
            "a.ply: has compressed splats (a .compressed.ply of PlayCanvas or SuperSplat); accepted: an uncompressed .ply, "
            "which splat-transform IN OUT.ply writes (npm's @playcanvas/splat-transform)");
}

TEST(Ply, text_and_binary_give_equal_meshes) {
  for (const std::string& file :
       {header("ascii") + "0 0 0\n2 0 0\n0 2 0\n3 0 1 2\n", header("binary_little_endian") + binary_triangle(false),
        header("binary_big_endian") + binary_triangle(true)}) {
    const Scene scene = ply_scene(file);
    EXPECT_EQ(mesh(scene).positions, (std::vector<Vec3f>{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}));
    ASSERT_EQ(mesh(scene).triangles.size(), 1u);
    EXPECT_TRUE(mesh(scene).normals.empty());
  }
}

TEST(Ply, vertices_bring_normals_colours_and_texture_coordinates) {
  const Scene scene =
      ply_scene(header("ascii",
                       "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\n"
                       "property uchar blue\nproperty uchar alpha\nproperty float s\nproperty float t\n") +
                "0 0 0 0 0 2 255 0 188 51 0.5 0.25\n1 0 0 0 0 2 0 0 0 255 0 0\n0 1 0 0 0 2 0 0 0 255 0 0\n3 0 1 2\n");
  const Mesh& m = mesh(scene);
  EXPECT_EQ(m.normals.at(0), Vec3f(0, 0, 1));
  EXPECT_EQ(m.colors.at(0).x, 1.0f);
  EXPECT_NEAR(m.colors.at(0).z, 0.5029f, 1e-4f);  // sRGB 188: ((188/255 + 0.055) / 1.055)^2.4
  EXPECT_EQ(m.alphas.at(0), 0.2f);
  EXPECT_EQ(m.uvs.at(0), Vec2f(0.5f, 0.75f));  // 0.25 in the file, where v points up
  EXPECT_TRUE(std::get<MetallicRoughness>(scene.materials.at(0).surface).blend);
}

TEST(Ply, faces_of_many_corners_become_triangles) {
  const Scene scene = ply_scene(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\nelement face 1\n"
      "property uchar red\nproperty list uchar uint vertex_index\nend_header\n0 0 0 1 0 0 1 1 0 0 1 0\n9 4 0 1 2 3\n");
  EXPECT_EQ(mesh(scene).triangles.size(), 2u);
}

TEST(Ply, faces_are_flipped_to_match_normals) {
  const std::string text = header("ascii", "property float nx\nproperty float ny\nproperty float nz\n");
  const Scene scene = ply_scene(text + "0 0 0 0 0 -1\n2 0 0 0 0 -1\n0 2 0 0 0 -1\n3 0 1 2\n");
  EXPECT_EQ(mesh(scene).triangles.at(0), (std::array<std::uint32_t, 3>{0, 2, 1}));
}

TEST(Ply, strips_wind_consistently) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 2 0\n";
  using Corners = std::array<std::uint32_t, 3>;
  EXPECT_THAT(mesh(ply_scene(text + "9 0 1 2 3 -1 1 4 3 3\n")).triangles,
              testing::ElementsAre(Corners{0, 1, 2}, Corners{2, 1, 3}, Corners{1, 4, 3}));
  EXPECT_THAT(ply_error(text + "3 0 1 5\n"), HasSubstr("tristrips 0: a vertex is 5; accepted: 0 to 4"));
}

TEST(Ply, accepts_unmarked_comments_but_no_misspellings) {
  std::string text = header("ascii") + "0 0 0\n2 0 0\n0 2 0\n3 0 1 2\n";
  text.insert(text.find("element"), "Created by a scanner\nVCGLIB generated\n");
  EXPECT_EQ(mesh(ply_scene(text)).triangles.size(), 1u);
  text.insert(text.find("element"), "elment face 1\n");
  EXPECT_THAT(ply_error(text), HasSubstr("'elment' is not a statement of the header"));
}

TEST(Ply, other_elements_are_left_out) {
  const Scene scene = ply_scene(
      "ply\nformat ascii 1.0\nelement material 1\nproperty int a\nproperty list uchar int b\nelement vertex 3\nproperty float "
      "x\n"
      "property float y\nproperty float z\nelement nothing 2147483647\nelement face 1\nproperty list uchar int vertex_indices\n"
      "end_header\n5 2 7 7\n0 0 0 1 0 0 0 1 0 3 0 1 2\n");
  EXPECT_EQ(mesh(scene).triangles.size(), 1u);
}

struct Square {
  std::string comments{}, vertex_properties{}, face_properties{};
  std::array<std::string, 4> vertex_values{};
  std::array<std::string, 2> face_values{};

  std::string text() const {
    std::string text = "ply\nformat ascii 1.0\n" + comments +
                       "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n" + vertex_properties +
                       "element face 2\nproperty list uchar int vertex_indices\n" + face_properties + "end_header\n";
    const char* corners[] = {"0 0 0", "1 0 0", "1 1 0", "0 1 0"};
    for (std::size_t i = 0; i < 4; ++i) text += std::string(corners[i]) + " " + vertex_values[i] + "\n";
    return text + "3 0 1 2 " + face_values[0] + "\n3 0 2 3 " + face_values[1] + "\n";
  }

  Scene load(const PlyOptions& options = {}) {
    Context context;
    context.warn = [this](std::string_view warning) { warnings.emplace_back(warning); };
    Scene scene = parse_ply("a.ply", text(), context, options);
    validate(scene, "a.ply");
    return scene;
  }

  std::vector<std::string> warnings{};
};

const std::string kRgbProperties = "property uchar red\nproperty uchar green\nproperty uchar blue\n";

Vec3f color_of(const Mesh& m, std::size_t triangle, std::size_t corner) {
  return m.colors.at(m.triangles.at(triangle)[corner]);
}

TEST(Ply, faces_have_colours_of_their_own) {
  Square square{.face_properties = kRgbProperties + "property uchar alpha\n", .face_values = {"255 0 0 255", "0 0 255 51"}};
  const Scene scene = square.load();
  const Mesh& m = mesh(scene);
  ASSERT_EQ(m.triangles.size(), 2u);
  for (const std::size_t corner : {0u, 1u, 2u}) {
    EXPECT_EQ(color_of(m, 0, corner), Vec3f(1, 0, 0));
    EXPECT_EQ(color_of(m, 1, corner), Vec3f(0, 0, 1));
    EXPECT_EQ(m.alphas.at(m.triangles[1][corner]), 0.2f);
  }
  EXPECT_EQ(m.positions.size(), 6u);  // the faces differ in colour, so their two common vertices are split
  EXPECT_THAT(square.warnings, testing::IsEmpty());
}

TEST(Ply, vertex_colours_override_face_colours) {
  Square square{.vertex_properties = kRgbProperties,
                .face_properties = kRgbProperties,
                .vertex_values = {"255 255 255", "255 255 255", "255 255 255", "255 255 255"},
                .face_values = {"255 0 0", "0 0 255"}};
  EXPECT_EQ(color_of(mesh(square.load()), 1, 2), Vec3f(1));
  EXPECT_THAT(square.warnings,
              testing::ElementsAre("a.ply: element 'face': the properties 'red', 'green' and 'blue' are left out."));
}

class PlyTextures : public testing::Test {
 protected:
  PlyTextures() {
    write("red.png", {255, 0, 0});
    write("two words.png", {0, 0, 255});
  }
  void write(const std::string& name, std::vector<std::uint8_t> rgb) const {
    write_png(dir_ / name, Image8{1, 1, std::move(rgb)});
  }
  PlyOptions here() const { return {{dir_.path(), {}}}; }
  static std::uint8_t red_of(const Scene& scene, std::size_t instance) {
    const auto material = static_cast<std::size_t>(scene.instances.at(instance).material);
    const auto& surface = std::get<MetallicRoughness>(scene.materials.at(material).surface);
    return surface.base_color_map.texture < 0
               ? std::uint8_t{1}
               : scene.textures.at(static_cast<std::size_t>(surface.base_color_map.texture)).rgba.at(0);
  }
  test::TempDir dir_;
};

TEST_F(PlyTextures, comment_names_the_picture_of_vertices) {
  for (const auto& [u, v] : {std::pair{"s", "t"}, std::pair{"u", "v"}, std::pair{"texture_u", "texture_v"}}) {
    Square square{.comments = "comment TextureFile red.png\n",
                  .vertex_properties = "property float " + std::string(u) + "\nproperty float " + v + "\n",
                  .vertex_values = {"0 0", "1 0", "1 1", "0 0.25"}};
    const Scene scene = square.load(here());
    EXPECT_EQ(red_of(scene, 0), 255) << u;
    EXPECT_EQ(mesh(scene).uvs.at(3), Vec2f(0, 0.75f)) << "v grows upwards in the file";
    EXPECT_THAT(square.warnings, testing::IsEmpty());
  }
}

TEST_F(PlyTextures, corners_have_coordinates_and_faces_a_picture) {
  Square square{.comments = "comment TextureFile red.png\ncomment texturefile two words.png\n",
                .face_properties = "property list uchar float texcoord\nproperty int texnumber\n",
                .face_values = {"6 0 0 1 0 1 1 1", "6 0 0 0.5 1 0 1 0"}};
  const Scene scene = square.load(here());
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(red_of(scene, 0), 255);
  EXPECT_EQ(red_of(scene, 1), 0);
  const Mesh& second = mesh(scene);
  EXPECT_EQ(second.uvs.at(second.triangles.at(0)[1]), Vec2f(0.5f, 0.0f));
  EXPECT_THAT(square.warnings, testing::IsEmpty());
}

TEST_F(PlyTextures, corners_come_before_vertices) {
  Square square{.comments = "comment TextureFile red.png\n",
                .vertex_properties = "property float s\nproperty float t\n",
                .face_properties = "property list uchar float texcoord\n",
                .vertex_values = {"9 9", "9 9", "9 9", "9 9"},
                .face_values = {"6 0 0 1 0 1 1", "6 0 0 1 1 0 1"}};
  const Scene scene = square.load(here());
  for (const Vec2f uv : mesh(scene).uvs) EXPECT_LE(uv.x, 1.0f);
  EXPECT_THAT(square.warnings, testing::ElementsAre(HasSubstr("coordinates of vertices are left out")));
}

TEST_F(PlyTextures, missing_picture_is_named_and_colours_stay) {
  Square square{.comments = "comment TextureFile foo.png\n",
                .face_properties = "property list uchar float texcoord\n" + kRgbProperties,
                .face_values = {"6 0 0 1 0 1 1 255 0 0", "6 0 0 1 1 0 1 0 0 255"}};
  const Scene scene = square.load(here());
  EXPECT_EQ(color_of(mesh(scene), 0, 0), Vec3f(1, 0, 0));
  EXPECT_THAT(square.warnings, testing::ElementsAre(HasSubstr("'foo.png' does not exist; the surface is shown without it")));
}

TEST_F(PlyTextures, picture_takes_the_place_of_colours) {
  Square square{.comments = "comment TextureFile red.png\n",
                .face_properties = "property list uchar float texcoord\n" + kRgbProperties,
                .face_values = {"6 0 0 1 0 1 1 9 9 9", "6 0 0 1 1 0 1 9 9 9"}};
  EXPECT_TRUE(mesh(square.load(here())).colors.empty());
  EXPECT_THAT(square.warnings, testing::ElementsAre(HasSubstr("red, green and blue are left out: the texture replaces them")));
}

TEST(Ply, uvs_and_textures_need_each_other) {
  Square no_picture{.vertex_properties = "property float s\nproperty float t\n", .vertex_values = {"0 0", "0 0", "0 0", "0 0"}};
  no_picture.load();
  EXPECT_THAT(no_picture.warnings, testing::ElementsAre(HasSubstr("no texture; add \"comment TextureFile NAME\"")));
  Square no_coordinates{.comments = "comment TextureFile foo.png\n"};
  no_coordinates.load();
  EXPECT_THAT(no_coordinates.warnings, testing::ElementsAre(HasSubstr("so its texture 'foo.png' is left out")));
}

TEST(Ply, face_uvs_must_match_corners) {
  Square square{.face_properties = "property list uchar float texcoord\n", .face_values = {"4 0 0 1 0", "0"}};
  EXPECT_THAT(test::error_message([&] { square.load(); }),
              HasSubstr("face 0: has 3 corners and 4 values texcoord; accepted: two values for each corner, or none"));
}

TEST(Ply, clamped_colours_are_counted) {
  Square square{.face_properties = "property float red\nproperty float green\nproperty float blue\n",
                .face_values = {"255 0.5 0", "0 0 1"}};
  square.load();
  EXPECT_THAT(square.warnings, testing::ElementsAre("a.ply: 1 colour values are clamped to 0 to 1."));
}

TEST(Ply, lists_are_not_coordinates) {
  EXPECT_THAT(ply_error("ply\nformat ascii 1.0\nelement vertex 1\nproperty list uchar float x\nproperty float y\n"
                        "property float z\nend_header\n1 0 0 0\n"),
              HasSubstr("its vertices have no position"));
}

TEST(Ply, damaged_headers_name_their_line) {
  EXPECT_THAT(ply_error("plu\n"), HasSubstr("a.ply:1: is not a PLY file but text that begins 'plu'"));
  EXPECT_THAT(ply_error("ply\nformat ascii 1.0\n"), HasSubstr("the file ends within its header"));
  EXPECT_THAT(ply_error("ply\nformat ebcdic 1.0\n"), HasSubstr("a.ply:2: 'ebcdic'"));
  EXPECT_THAT(ply_error("ply\nelement vertex -1\n"), HasSubstr("a.ply:2: '-1'"));
  EXPECT_THAT(ply_error("ply\nproperty float x\n"), HasSubstr("a.ply:2: a property precedes"));
  EXPECT_THAT(ply_error("ply\nelement f 1\nproperty list float int x\n"), HasSubstr("a.ply:3: the length"));
}

TEST(Ply, damaged_bodies_name_the_element) {
  const std::string good = header("ascii");
  EXPECT_THAT(ply_error(good + "0 0 0 1 0 0 0 1 0 3 0 1 3"), HasSubstr("a.ply: face 0: a vertex is 3"));
  EXPECT_THAT(ply_error(good + "0 0 0 1 0 0 0 1 0 3 0 1 -1"), HasSubstr("a.ply: face 0: a vertex is -1"));
  EXPECT_THAT(ply_error(good + "0 0 0 1 0 0 0 1 0 200 0 1 2"), HasSubstr("face 0: the length of a list is 200"));
  EXPECT_THAT(ply_error(good + "0 0 0 1 nan 0 0 1 0 3 0 1 2"), HasSubstr("a.ply: vertex 1:"));
  EXPECT_THAT(ply_error(good + "0 0 0 1 x 0"), HasSubstr("vertex 1: 'x' is not a number"));
  EXPECT_THAT(ply_error(good + "0 0 0 1 0"), HasSubstr("vertex 1: the file ends here"));
  EXPECT_THAT(ply_error(header("binary_little_endian") + "abc"), HasSubstr("vertex 0: the file ends here"));
}

TEST(Ply, zero_area_faces_are_reported) {
  EXPECT_THAT(ply_error(header("ascii") + "0 0 0\n1 1 1\n2 2 2\n3 0 1 2\n"),
              HasSubstr("a.ply: all of its faces have zero area"));
  EXPECT_THAT(ply_error(header("ascii") + "0 0 0\n1 0 0\n0 1 0\n2 0 1\n"), HasSubstr("faces of at least three corners"));
}

TEST(Ply, faces_may_stand_before_the_vertices) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nend_header\n";
  EXPECT_EQ(mesh(ply_scene(text + "3 0 1 2\n0 0 0\n2 0 0\n0 2 0\n")).triangles.size(), 1u);
  EXPECT_THAT(ply_error(text + "3 0 1 3\n0 0 0\n2 0 0\n0 2 0\n"), HasSubstr("face 0: a vertex is 3; accepted: 0 to 2"));
}

TEST(Ply, infinite_attributes_are_dropped_by_name) {
  Square square{.vertex_properties =
                    "property float nx\nproperty float ny\nproperty float nz\nproperty float u\n"
                    "property float v\nproperty float red\nproperty float green\nproperty float blue\n"
                    "property float alpha\n",
                .vertex_values = {"0 0 1 0 0 1 1 1 1", "0 nan 1 0 0 1 1 1 1", "0 0 1 inf 0 1 1 1 1", "0 0 1 0 0 1 1 nan nan"}};
  const Scene scene = square.load();
  EXPECT_TRUE(mesh(scene).normals.empty() && mesh(scene).uvs.empty() && mesh(scene).colors.empty() &&
              mesh(scene).alphas.empty());
  for (const std::string property : {"ny", "u", "blue", "alpha"})
    EXPECT_THAT(square.warnings, testing::Contains(HasSubstr("property '" + property + "'"))) << property;
  EXPECT_THAT(ply_error(header("ascii") + "0 0 0 1 nan 0 0 1 0 3 0 1 2"),
              HasSubstr("vertex 1: property 'y' has the value nan"));
}

TEST(Ply, file_is_found_by_its_extension) {
  const test::TempDir dir;
  std::ofstream(dir / "a.ply") << header("ascii") << "0 0 0\n2 0 0\n0 2 0\n3 0 1 2\n";
  EXPECT_EQ(load_scene((dir / "a.ply").string(), {}, Context{}).name, "a");
}

}  // namespace
}  // namespace lippmann
