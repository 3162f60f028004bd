// Importers must throw or warn about unknown properties, elements, extensions and keywords, and name them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <utility>
#include <vector>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

struct UnknownThing {
  std::string name;
  std::string scene;
  std::string text;
  std::string met = "frog";  ///< unknown name, which the message must contain
  std::vector<std::pair<std::string, std::string>> beside{};
};
void PrintTo(const UnknownThing& thing, std::ostream* out) { *out << thing.name; }

class Unknown : public testing::TestWithParam<UnknownThing> {
 protected:
  void write(const std::string& name, const std::string& contents) const {
    std::ofstream(dir_ / name, std::ios::binary) << contents;
  }
  test::TempDir dir_;
};

TEST_P(Unknown, named_by_an_error_or_warning) {
  write(GetParam().scene, GetParam().text);
  for (const auto& [name, contents] : GetParam().beside) write(name, contents);
  std::vector<std::string> messages;
  Context context;
  context.warn = [&](std::string_view warning) { messages.emplace_back(warning); };
  LoadOptions options;
  if (std::filesystem::exists(dir_ / "a.cam")) options.camera_path = dir_ / "a.cam";
  try {
    load_scene((dir_ / GetParam().scene).string(), options, context);
  } catch (const Error& error) {
    messages.emplace_back(error.what());
  }
  EXPECT_THAT(messages, testing::Contains(testing::HasSubstr(GetParam().met)));
}

std::string ply(const std::string& vertex, const std::string& face, const std::string& more = {}, const std::string& v = {},
                const std::string& f = {}, const std::string& m = {}) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
                     vertex + "element face 1\nproperty list uchar int vertex_indices\n" + face + more + "end_header\n";
  for (const char* const corner : {"0 0 0 ", "1 0 0 ", "0 1 0 "}) text += corner + v + "\n";
  return text + "3 0 1 2 " + f + "\n" + m;
}

std::string splat_ply(const std::string& property, const std::string& element, const std::string& value,
                      const std::string& row) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex 1\n";
  for (const char* const name : {"x", "y", "z", "f_dc_0", "f_dc_1", "f_dc_2", "opacity", "scale_0", "scale_1", "scale_2",
                                 "rot_0", "rot_1", "rot_2", "rot_3"})
    text += "property float " + std::string(name) + "\n";
  return text + property + element + "end_header\n0 0 0 0 0 0 0 0 0 0 1 0 0 0 " + value + "\n" + row;
}

/// The accessor has no buffer view, so all vertices are zero.
std::string gltf(const std::string& root, const std::string& primitive = {}, const std::string& attributes = {},
                 const std::string& material = {}) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"materials":[{)" + material +
         R"(}],"accessors":[{"componentType":5126,"count":3,"type":"VEC3"}],"meshes":[{"primitives":[{"material":0,)" +
         primitive + R"("attributes":{"POSITION":0)" + attributes + "}}]}]" + root + "}";
}

std::string lamp(const std::string& file) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"extensions":{"EXT_lights_ies":{"light":0}}}],)"
         R"("extensions":{"EXT_lights_ies":{"lights":[{"uri":")" +
         file + R"("}]}},"extensionsUsed":["EXT_lights_ies"]})";
}

std::string ies(const std::string& keyword, const std::string& tilt = "TILT=NONE\n", const std::string& end = {}) {
  return "IESNA:LM-63-2002\n[TEST] 1\n[_MINE] 2\n" + keyword + tilt + "1 1000 1 2 1 1 2 0 0 0\n1 1 50\n0 90\n0\n100 50\n" + end;
}

std::string dat(const std::string& statements, const std::string& camera = {}) {
  return "BEGIN_SCENE RESOLUTION 4 4 CAMERA " + camera +
         " ZOOM 1 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 1 CENTER 0 0 0 VIEWDIR 0 0 1 UPDIR 0 1 0 END_CAMERA\n" + statements +
         "\nSPHERE CENTER 0 0 5 RAD 1 a\nEND_SCENE\n";
}

const std::string kMesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", kFace = "f 1 2 3\n";
const std::string kPose = "0 0 1 0 1 0 0 0 0\n";

const UnknownThing kThings[] = {
    {"ply_vertex_property", "a.ply", ply("property float frog\n", "", "", "7")},
    {"ply_vertex_list", "a.ply", ply("property list uchar float frog\n", "", "", "2 7 7")},
    {"ply_second_of_a_name", "a.ply", ply("property float x\n", "", "", "7"), "'x'"},
    {"ply_half_a_normal", "a.ply", ply("property float nx\n", "", "", "1"), "'nx'"},
    {"ply_face_property", "a.ply", ply("", "property uchar frog\n", "", "", "7")},
    {"ply_face_list", "a.ply", ply("", "property list uchar float frog\n", "", "", "1 7")},
    {"ply_element", "a.ply", ply("", "", "element frog 1\nproperty int leg\n", "", "", "4\n")},
    {"ply_header_line", "a.ply", ply("frog is not a comment\n", "")},
    {"ply_type", "a.ply", ply("property frog nx\n", "")},
    {"ply_texture", "a.ply", ply("comment TextureFile frog.png\n", "")},
    {"ply_strip_property", "a.ply",
     "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\n"
     "property list int int vertex_indices\nproperty int frog\nend_header\n0 0 0 1 0 0 0 1 0 3 0 1 2 7\n"},
    {"splat_property", "a.ply", splat_ply("property float frog\n", "", "7", "")},
    {"splat_list", "a.ply", splat_ply("property list uchar int frog\n", "", "1 7", "")},
    {"splat_element", "a.ply", splat_ply("", "element frog 1\nproperty float leg\n", "", "4\n")},
    {"obj_statement", "a.obj", kMesh + "frog 1\n" + kFace},
    {"obj_line", "a.obj", kMesh + "l 1 2\n" + kFace, "'l'"},
    {"obj_material", "a.obj", kMesh + "usemtl frog\n" + kFace},
    {"obj_library", "a.obj", kMesh + "mtllib frog.mtl\n" + kFace},
    {"mtl_statement", "a.obj", kMesh + "mtllib a.mtl\nusemtl m\n" + kFace, "'frog'", {{"a.mtl", "newmtl m\nfrog 1\n"}}},
    {"mtl_map", "a.obj", kMesh + "mtllib a.mtl\nusemtl m\n" + kFace, "'map_Bump'", {{"a.mtl", "newmtl m\nmap_Bump a.png\n"}}},
    {"mtl_halo", "a.obj", kMesh + "mtllib a.mtl\nusemtl m\n" + kFace, "'d'", {{"a.mtl", "newmtl m\nd -halo 0.5\n"}}},
    {"mtl_map_option",
     "a.obj",
     kMesh + "mtllib a.mtl\nusemtl m\n" + kFace,
     "'-frog'",
     {{"a.mtl", "newmtl m\nmap_Kd -frog 1 a.png\n"}}},
    {"nff_statement", "a.nff", "s 0 0 0 1\nfrog\n"},
    {"nff_view", "a.nff", "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nfrog 1\ns 0 0 0 1\n"},
    {"nff_word_behind", "a.nff", "s 0 0 0 1 frog\n"},
    {"tachyon_statement", "a.dat", dat("FROG 1"), "FROG"},
    {"tachyon_shader_option", "a.dat", dat("SHADER_MODE FULL FROG END_SHADER_MODE"), "FROG"},
    {"tachyon_projection", "a.dat", dat("", "PROJECTION FROG"), "FROG"},
    {"tachyon_texture_word", "a.dat", dat("TEXDEF t AMBIENT 0 DIFFUSE 1 SPECULAR 0 OPACITY 1 FROG 1 COLOR 1 1 1 TEXFUNC 0"),
     "FROG"},
    {"tachyon_texture_name", "a.dat", dat("SPHERE CENTER 0 0 5 RAD 1 frog")},
    {"tachyon_effect", "a.dat", dat("FOG LINEAR START 0 END 1 DENSITY 1 COLOR 1 1 1"), "FOG"},
    {"tachyon_camera_path", "a.dat", dat(""), "frog", {{"a.cam", kPose + "frog\n"}}},
    {"tachyon_polygons",
     "a.dat",
     dat("TPOLYFILE SCALE 1 1 1 ROT 0 0 0 CENTER 0 0 0 FILE a.tpoly a"),
     "frog",
     {{"a.tpoly", "3 0 0 0 1 0 0 0 1 0 frog\n"}}},
    {"tachyon_included", "a.dat", dat("INCLUDE a.inc"), "FROG", {{"a.inc", "FROG\n"}}},
    {"gltf_extension", "a.gltf", gltf(R"(,"extensionsUsed":["FROG_leg"])"), "FROG_leg"},
    {"gltf_extension_of_an_object", "a.gltf", gltf("", R"("extensions":{"FROG_leg":{}},)"), "FROG_leg"},
    {"gltf_required_extension", "a.gltf", gltf(R"(,"extensionsRequired":["FROG_leg"])"), "FROG_leg"},
    {"gltf_root_property", "a.gltf", gltf(R"(,"frog":1)")},
    {"gltf_material_property", "a.gltf", gltf("", "", "", R"("frog":1)"), "materials[0]: the property 'frog' is left out"},
    {"gltf_attribute", "a.gltf", gltf("", "", R"(,"COLOR_1":0)"), "COLOR_1"},
    {"gltf_application_attribute", "a.gltf", gltf("", "", R"(,"_FROG":0)"), "_FROG"},
    {"ies_keyword", "a.gltf", lamp("a.ies"), "'[FROG]'", {{"a.ies", ies("[FROG] 4 legs\n")}}},
    {"ies_tilt", "a.gltf", lamp("a.ies"), "'TILT'", {{"a.ies", ies("", "TILT=INCLUDE\n1\n2\n0 90\n1 0.5\n")}}},
    {"ies_more", "a.gltf", lamp("a.ies"), "'frog'", {{"a.ies", ies("", "TILT=NONE\n", "frog\n")}}},
};

INSTANTIATE_TEST_SUITE_P(All, Unknown, testing::ValuesIn(kThings), [](const auto& thing) { return thing.param.name; });

TEST(LeftOut, usual_files_warn_of_nothing) {
  const test::TempDir dir;
  std::ofstream(dir / "a.mtl") << "newmtl m\nKa 1 1 1\nKd 1 0 0\nKs 0.5 0.5 0.5\nNs 10\nNi 1.5\nd 1\nillum 2\n";
  std::ofstream(dir / "a.obj") << "mtllib a.mtl\no a\ng b\n" + kMesh + "vn 0 0 1\ns 1\nusemtl m\nf 1//1 2//1 3//1\n";
  std::ofstream(dir / "a.ply") << ply("comment made by hand\nobj_info nothing\n", "");
  std::ofstream(dir / "a.gltf") << gltf(R"(,"extras":{"frog":1},"cameras":[{"name":"c","type":"perspective","extras":{"a":1},)"
                                        R"("perspective":{"yfov":1,"znear":0.1}}])");
  std::vector<std::string> warnings;
  Context context;
  context.warn = [&](std::string_view warning) { warnings.emplace_back(warning); };
  for (const char* const name : {"a.obj", "a.ply", "a.gltf"}) load_scene((dir / name).string(), {}, context);
  EXPECT_THAT(warnings, testing::IsEmpty());
}

}  // namespace
}  // namespace lippmann
