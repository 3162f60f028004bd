#include "scene/obj.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "image/png.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Obj : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& contents) const {
    std::ofstream(dir_ / name, std::ios::binary) << contents;
  }

  Scene load(const std::string& text) {
    write("a.obj", text);
    Context context;
    context.warn = [this](std::string_view warning) { warnings.emplace_back(warning); };
    Scene scene = load_obj(dir_ / "a.obj", context);
    validate(scene, "a.obj");
    return scene;
  }

  std::string error_of(const std::string& text) {
    try {
      load(text);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  MetallicRoughness surface_of(const std::string& statements) {
    write("a.mtl", "newmtl the one\n" + statements + "\n");
    const Scene scene = load("mtllib a.mtl\n" + kTriangle + "usemtl the one\nf 1 2 3\n");
    return std::get<MetallicRoughness>(scene.materials.at(static_cast<std::size_t>(scene.instances.at(0).material)).surface);
  }

  static const Mesh& mesh(const Scene& scene, std::size_t instance = 0) {
    return std::get<Mesh>(scene.shapes.at(static_cast<std::size_t>(scene.instances.at(instance).shape)));
  }

  const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  test::TempDir dir_;
  std::vector<std::string> warnings;
};

TEST_F(Obj, corners_share_vertices_where_all_attributes_agree) {
  const Scene scene = load(kTriangle + "v 1 1 0\nvt 0 0\nvt 1 0.25\nvn 0 0 2\nf 1/1/1 2/2/1 3/1/1\nf 2/2/1 4/1/1 3/1/1\n");
  const Mesh& m = mesh(scene);
  EXPECT_EQ(m.positions.size(), 4u);
  EXPECT_EQ(m.triangles.size(), 2u);
  EXPECT_EQ(m.uvs.at(1), Vec2f(1.0f, 0.75f));  // vt 1 0.25: v points up in the file, but down in a Mesh
  EXPECT_EQ(m.normals.at(0), Vec3f(0, 0, 1));
  EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(Obj, negative_indices_count_backwards) {
  EXPECT_EQ(mesh(load(kTriangle + "f -3 -2 -1\n")).positions.at(1), Vec3f(1, 0, 0));
}

TEST_F(Obj, triangulates_concave_faces) {
  const Mesh m = mesh(load("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n"));
  float area = 0.0f;
  for (const auto& t : m.triangles)
    area += 0.5f * glm::cross(m.positions[t[1]] - m.positions[t[0]], m.positions[t[2]] - m.positions[t[0]]).z;
  EXPECT_EQ(area, 10.0f);  // square minus notch: 16 - 6
}

TEST_F(Obj, accepts_utf_16_and_byte_order_marks) {
  const std::string text = kTriangle + "o \xc3\xa9\nf 1 2 3\n";  // e with an acute accent (U+00E9) in UTF-8
  const auto utf16 = [&](bool low_first) {
    std::string wide;
    for (const char c : kTriangle + "o \xe9\nf 1 2 3\n") wide += low_first ? std::string{c, '\0'} : std::string{'\0', c};
    return wide;
  };
  for (const std::string& file :
       {text, "\xef\xbb\xbf" + text, "\xff\xfe" + utf16(true), "\xfe\xff" + utf16(false), utf16(true), utf16(false)}) {
    const Scene scene = load(file);
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.instances[0].name, "\xc3\xa9");
    EXPECT_EQ(mesh(scene).triangles.size(), 1u);
  }
}

TEST_F(Obj, skips_points_and_lines) {
  EXPECT_EQ(mesh(load(kTriangle + "p 1 2\nl 1 2 3\nf 1 2 3\n")).triangles.size(), 1u);
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("a.obj:4: the statements 'p' and 'l' are left out.")));
}

TEST_F(Obj, smoothing_without_normals_is_named) {
  load(kTriangle + "s off\nf 1 2 3\nvn 0 0 1\ns 1\nf 1//1 2//1 3//1\n");
  EXPECT_THAT(warnings, IsEmpty());
  load(kTriangle + "s 1\nf 1 2 3\nf 3 2 1\n");
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("a.obj:5: faces of smoothing groups (s) without normals (vn) are faceted.")));
}

TEST_F(Obj, short_lines_are_named_where_they_stand) {
  EXPECT_THAT(error_of("v 0 0\nv 1 0 0\n"), HasSubstr("a.obj:1: v has 2 numbers; accepted: 3 or more"));
  EXPECT_THAT(error_of("vt\nv 1 0 0\n"), HasSubstr("a.obj:1: vt has no number"));
}

TEST_F(Obj, one_instance_per_object_and_material) {
  const Scene scene = load(kTriangle + "o one\nf 1 2 3\no two\nf 1 2 3\nf 3 2 1\no one\nf 1 3 2\n");
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.instances[0].name, "one");
  EXPECT_EQ(mesh(scene, 0).triangles.size(), 2u);
  EXPECT_EQ(scene.instances[1].name, "two");
}

TEST_F(Obj, colours_of_vertices_are_srgb) {
  const Mesh m = mesh(load("v 0 0 0 1 0 0.5\nv 1 0 0 1 1 1\nv 0 1 0\nf 1 2 3\n"));
  ASSERT_EQ(m.colors.size(), 3u);
  EXPECT_NEAR(m.colors[0].z, 0.2140f, 1e-4f);  // sRGB 0.5: ((0.5 + 0.055) / 1.055)^2.4
  EXPECT_EQ(m.colors[2], Vec3f(1.0f));
}

TEST_F(Obj, line_may_go_on_behind_a_backslash) { EXPECT_EQ(mesh(load(kTriangle + "f 1 \\\n2 3\n")).triangles.size(), 1u); }

TEST_F(Obj, material_becomes_a_physical_surface) {
  const MetallicRoughness s = surface_of("Kd 0.1 0.2 0.3\nKe 4 5 6\nNs 30\nNi 1.4\nd 0.25\nillum 2\nKa 1 1 1");
  EXPECT_EQ(s.base_color, Vec4f(0.1f, 0.2f, 0.3f, 0.25f));
  EXPECT_EQ(s.emissive, Vec3f(4, 5, 6));
  // Ns = 30: alpha^2 = 2 / (30 + 2) = 1/16, and the roughness is sqrt(alpha) = 1/2
  EXPECT_FLOAT_EQ(s.roughness, 0.5f);
  EXPECT_EQ(s.ior, 1.4f);
  EXPECT_TRUE(s.blend);
  EXPECT_TRUE(s.double_sided);
  EXPECT_EQ(s.metallic, 0.0f);
  EXPECT_EQ(s.specular, 1.0f);
}

TEST_F(Obj, physical_extension_wins_over_the_exponent) {
  const MetallicRoughness s = surface_of("Pr 0.3\nPm 1\nNs 30\nTr 0");
  EXPECT_EQ(s.roughness, 0.3f);
  EXPECT_EQ(s.metallic, 1.0f);
  EXPECT_FALSE(s.blend);
}

TEST_F(Obj, black_highlight_is_none) { EXPECT_EQ(surface_of("Ks 0 0 0").specular, 0.0f); }

TEST_F(Obj, texture_is_read_behind_its_options) {
  write_png(dir_ / "a b.png", Image8{1, 1, {10, 20, 30}});
  write("a.mtl", "newmtl m\nmap_Kd -s 1 1 1 -clamp on a b.png\nmap_Ke a b.png\n");
  const Scene scene = load("mtllib a.mtl\n" + kTriangle + "vt 0 0\nusemtl m\nf 1/1 2/1 3/1\n");
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_THAT(scene.textures[0].rgba, ElementsAre(10, 20, 30, 255));
  const auto& s = std::get<MetallicRoughness>(scene.materials.at(0).surface);
  EXPECT_EQ(s.base_color_map.texture, 0);
  EXPECT_EQ(s.emissive_map.texture, 0);
  EXPECT_EQ(s.emissive, Vec3f(1.0f));
}

TEST_F(Obj, missing_files_and_materials_are_warnings) {
  load("mtllib none.mtl\n" + kTriangle + "usemtl m\nf 1 2 3\n");
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("'none.mtl' does not exist"), HasSubstr("there is no material 'm'")));
  warnings.clear();
  EXPECT_EQ(surface_of("map_Kd none.png").base_color_map.texture, -1);
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("'none.png' does not exist")));
}

TEST_F(Obj, outside_files_are_not_opened) {
  const auto refused = [](const std::string& name) {
    return testing::AllOf(HasSubstr("'" + name + "' is outside the scene's folder"), HasSubstr("`asset-root` DIR"));
  };
  load("mtllib ../a.mtl\n" + kTriangle + "f 1 2 3\n");
  EXPECT_THAT(warnings, ElementsAre(refused("../a.mtl")));
  warnings.clear();
  EXPECT_EQ(surface_of("map_Kd /etc/hostname\nKd 1 0 0").base_color_map.texture, -1);
  EXPECT_THAT(warnings, ElementsAre(refused("/etc/hostname")));
}

TEST_F(Obj, files_below_the_asset_root_are_opened) {
  std::filesystem::create_directory(dir_ / "model");
  write("above.mtl", "newmtl m\nPm 0.5\n");
  write("model/b.obj", "mtllib ../above.mtl\n" + kTriangle + "usemtl m\nf 1 2 3\n");
  const Scene scene = load_obj(dir_ / "model/b.obj", Context{}, dir_.path());
  EXPECT_EQ(std::get<MetallicRoughness>(scene.materials.at(0).surface).metallic, 0.5f);
}

TEST_F(Obj, errors_name_the_line) {
  EXPECT_THAT(error_of(kTriangle + "f 1 2 4\n"), HasSubstr("a.obj:4: '4' refers to a vertex that does not exist"));
  EXPECT_THAT(error_of(kTriangle + "f 1/1 2/1 3/1\n"), HasSubstr("'1/1' refers to a texture coordinate that does not exist"));
  EXPECT_THAT(error_of(kTriangle + "f 1//1 2//1 3//1\n"), HasSubstr("accepted: a normal before the face"));
  EXPECT_THAT(error_of(kTriangle + "f 1 2 0\n"), HasSubstr("a.obj:4: '0' refers to"));
  EXPECT_THAT(error_of(kTriangle + "f 1/1 2/1 3/1\n"), HasSubstr("a.obj:4: '1/1' refers to"));
  EXPECT_THAT(error_of(kTriangle + "f 1 2 99999999999999999999\n"), HasSubstr("a.obj:4:"));
  EXPECT_THAT(error_of(kTriangle + "f 1 2\n"), HasSubstr("a.obj:4: a face has 2 corners"));
  EXPECT_THAT(error_of("v 0 0 nan\n"), HasSubstr("a.obj:1: expected a number for v, found 'nan'"));
  EXPECT_THAT(error_of("v 0 0"), HasSubstr("a.obj:1: v has 2 numbers; accepted: 3 or more"));
}

TEST_F(Obj, faces_are_flipped_to_match_normals) {
  const std::string normal = kTriangle + "vn 0 0 1\n";
  const Scene with = load(normal + "f 1//1 2//1 3//1\n"), against = load(normal + "f 1//1 3//1 2//1\n");
  const auto facet = [&](const Scene& scene) {
    const auto& [a, b, c] = mesh(scene).triangles.at(0);
    const std::vector<Vec3f>& p = mesh(scene).positions;
    return glm::cross(p[b] - p[a], p[c] - p[a]);
  };
  EXPECT_EQ(facet(with), Vec3f(0, 0, 1));
  EXPECT_EQ(facet(against), Vec3f(0, 0, 1));
}

TEST_F(Obj, unknown_statements_give_one_warning) {
  EXPECT_TRUE(load("g a\ns 1\ncstype bezier\ncurv 0 1 1 2\n").instances.empty());
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("a.obj:3: the statements 'cstype' and 'curv' are left out.")));
}

}  // namespace
}  // namespace lippmann
