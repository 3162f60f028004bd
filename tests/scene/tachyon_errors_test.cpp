// Errors name the file, the line, the keyword and the accepted values.
#include "tachyon_support.hpp"

namespace lippmann {
namespace {

using test::Tachyon;
using test::TachyonFiles;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

struct BadStatement {
  const char* name;
  const char* text;
  const char* problem;
  const char* accepted;
};
void PrintTo(const BadStatement& bad, std::ostream* out) { *out << bad.name; }

class TachyonBadStatement : public testing::TestWithParam<BadStatement> {};

TEST_P(TachyonBadStatement, error_names_line_keyword_and_accepted) {
  TachyonFiles files;
  EXPECT_THAT(files.error_of_statements(GetParam().text),
              AllOf(StartsWith(std::string("scene.dat:") + GetParam().problem), HasSubstr(GetParam().accepted)));
}

const char* const kTexture = "TEXDEF a AMBIENT 0 DIFFUSE 1 SPECULAR 0 ";

#define TEXTURE_UP_TO_OPACITY "TEXDEF a\nAMBIENT 0 DIFFUSE 1 SPECULAR 0 OPACITY 1\n"
#define CAMERA_WITH(text) "CAMERA\n" text " CENTER 0 0 0 VIEWDIR 0 0 1 UPDIR 0 1 0 END_CAMERA"

const BadStatement kBad[] = {
    // Supported by Tachyon, but not by a Scene.
    {"cylinder", "CYLINDER CENTER 0 0 0", "4: CYLINDER is not supported", "FCYLINDER"},
    {"clip", "\n\nSTART_CLIPGROUP NUMPLANES 1", "6: START_CLIPGROUP is not supported", "SPHERE"},
    {"fog", "FOG SMOKE", "4: FOG 'SMOKE' is not known", "LINEAR, EXP, EXP2, OFF"},
    {"mgf", "MGFFILE a.mgf", "4: MGFFILE is not supported", "INCLUDE"},
    {"volume", "ScalarVol MIN 0 0 0", "4: SCALARVOL is not supported", "BOX"},
    {"sky", "SKY_LIGHT SAMPLES 1", "4: expected NUMSAMPLES, found 'SAMPLES'", ""},
    {"texfunc_1", TEXTURE_UP_TO_OPACITY "COLOR 1 1 1 TEXFUNC 1", "6: TEXFUNC 1 is not supported",
     "9 (cylindrical, spherical and planar image map)"},
    {"gradient_kind", "BACKGROUND_GRADIENT SKY_BOX", "4: BACKGROUND_GRADIENT 'SKY_BOX' is not known",
     "SKY_SPHERE, SKY_ORTHO_PLANE"},
    {"texfunc_10", TEXTURE_UP_TO_OPACITY "COLOR 1 1 1 TEXFUNC 10", "6: TEXFUNC 10 is not supported", "TEXFUNC 0"},
    {"texfunc_11", TEXTURE_UP_TO_OPACITY "COLOR 1 1 1 TEXFUNC 11", "6: TEXFUNC 11 is not known", "TEXFUNC 0"},
    {"fisheye", "CAMERA PROJECTION FISHEYE", "4: the projection 'FISHEYE' is not supported", "PERSPECTIVE"},
    {"dof", "CAMERA PROJECTION perspective_dof ZOOM", "4: expected FOCALDIST, found 'ZOOM'", "FOCALLENGTH"},
    {"frustum",
     "CAMERA ZOOM 1 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 1 CENTER 0 0 0 VIEWDIR 0 0 1 UPDIR 0 1 0 FRUSTUM -1 2 -1 1 "
     "END_CAMERA",
     "4: only a symmetric FRUSTUM is supported", "left = -right < 0"},
    {"shader_quality", "SHADER_MODE HIGHEST END_SHADER_MODE", "4: 'HIGHEST' is not a quality of SHADER_MODE", "LOWEST"},
    {"shader_option", "SHADER_MODE FULL TRANS_VIP END_SHADER_MODE", "4: 'TRANS_VIP' is not an option of SHADER_MODE",
     "TRANS_VMD"},

    {"unknown", "FROG", "4: 'FROG' is not a statement of a scene", "SPHERE"},
    {"misspelt", "SPEHRE CENTER", "4: 'SPEHRE' is not a statement of a scene (did you mean SPHERE?)", "TEXDEF"},
    {"binary", "\x01\xff\x02", "4: '?\?\?' is not a statement", "BOX"},
    {"word_missing", "SPHERE CENTER 0 0 0\n1", "5: expected RAD, found '1'", ""},
    {"texture_word_missing", TEXTURE_UP_TO_OPACITY "TEXFUNC 0", "6: expected COLOR, found 'TEXFUNC'", "PHONG"},
    {"phong_kind", TEXTURE_UP_TO_OPACITY "PHONG WOOD 0.5", "6: PHONG 'WOOD' is not known", "PLASTIC, METAL"},
    {"end_camera", "CAMERA ZOOM 1 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 1 CENTER 0 0 0 VIEWDIR 0 0 1 UPDIR 0 1 0 SPHERE",
     "4: expected END_CAMERA, found 'SPHERE'", "FRUSTUM"},
    {"light_color", "LIGHT CENTER 0 0 0 RAD 1 COLOUR 1 1 1", "4: expected COLOR, found 'COLOUR'", "ATTENUATION"},
    {"array_block", "VERTEXARRAY NUMVERTS 1 COORDS 0 0 0 NORMALS 0 0 1 QUADS", "4: 'QUADS' is not a block", "TRISTRIP"},
    {"imagedef_format", "IMAGEDEF a FORMAT RGB48", "4: expected RGB24, found 'RGB48'", ""},
    {"imagedef_digits", "IMAGEDEF a FORMAT RGB24 RESOLUTION 1 1 1 ENCODING HEX 12", "4: '12' is not a colour", "3, 6, 9 or 12"},
    {"imagedef_letters", "IMAGEDEF a FORMAT RGB24 RESOLUTION 1 1 1 ENCODING HEX xyz", "4: 'xyz' is not a colour",
     "hexadecimal"},
    {"imagedef_twice",
     "IMAGEDEF a FORMAT RGB24 RESOLUTION 1 1 1 ENCODING HEX 123 IMAGEDEF a FORMAT RGB24 RESOLUTION 1 1 1 ENCODING HEX 123",
     "4: the image 'a' is already defined", ""},

    {"nan", "SPHERE CENTER 0 nan 0 RAD 1 a", "4: expected a number for CENTER, found 'nan'", "a finite decimal number"},
    {"inf", "SPHERE CENTER 0 0 0 RAD inf a", "4: expected a number for RAD, found 'inf'", "finite"},
    {"overflow", "SPHERE CENTER 0 0 0 RAD 1e39 a", "4: expected a number for RAD, found '1e39'", "finite"},
    {"negative_radius", "SPHERE CENTER 0 0 0 RAD -1 a", "4: RAD is -1", "a number >= 0"},
    {"negative_ring", "RING CENTER 0 0 0 NORMAL 0 0 1 INNER -1 OUTER 1 a", "4: INNER is -1", "a number >= 0"},
    {"zero_normal", "PLANE CENTER 0 0 0 NORMAL 0 0 0 a", "4: NORMAL is zero", "a non-zero vector"},
    {"zero_ring_normal", "RING CENTER 0 0 0 NORMAL 0 0 0 INNER 0 OUTER 1 a", "4: NORMAL is zero", "a non-zero vector"},
    {"zero_direction", "DIRECTIONAL_LIGHT DIRECTION 0 0 0 COLOR 1 1 1", "4: DIRECTION is zero", "a non-zero vector"},
    {"negative_light", "LIGHT CENTER 0 0 0 RAD -0.1 COLOR 1 1 1", "4: RAD is -0.1", "a number >= 0"},
    {"attenuation", "LIGHT CENTER 0 0 0 RAD 1 ATTENUATION CONSTANT 0 LINEAR 0 QUADRATIC 0", "4: ATTENUATION is 0, 0, 0",
     "at least one of them > 0"},
    {"negative_attenuation", "LIGHT CENTER 0 0 0 RAD 1 ATTENUATION CONSTANT 1 LINEAR -1 QUADRATIC 0",
     "4: ATTENUATION is 1, -1, 0", "three numbers >= 0"},
    {"flat_gradient", "BACKGROUND_GRADIENT SKY_SPHERE UPDIR 0 1 0 TOPVAL 0.5 BOTTOMVAL 0.5",
     "4: TOPVAL and BOTTOMVAL do not define a gradient", "two different"},
    {"gradient_up", "BACKGROUND_GRADIENT SKY_SPHERE UPDIR 0 0 0", "4: UPDIR is zero", "a non-zero vector"},
    {"landscape_of_one", "SCAPE RES 1 5", "4: 1 is out of range for RES", "from 2 to 2048"},
    {"landscape_too_large",
     "SCAPE RES 2048 2 SCALE 1 1 CENTER 0 0 0 a\nSCAPE RES 2 2048 SCALE 1 1 CENTER 0 0 0 a\nSCAPE RES 2 2",
     "6: the scene's landscapes are too large", "8388608"},
    {"landscape_flat", "SCAPE RES 2 2 SCALE 1 0", "4: SCALE is 0", "above 0"},
    {"vcstri_color",
     "VCSTRI V0 0 0 0 V1 1 0 0 V2 0 1 0 N0 0 0 1 N1 0 0 1 N2 0 0 1 C0 1 1 1 C1 1 1 1 C2 1 1 1 AMBIENT 0 DIFFUSE 1 SPECULAR 0 "
     "OPACITY 1 COLOR",
     "4: expected VCST, found 'COLOR'", "PHONG, VCST"},
    {"falloff", "SPOTLIGHT CENTER 0 0 0 RAD 0 DIRECTION 0 0 1 FALLOFF_START 50 FALLOFF_END 40",
     "4: the falloff runs from 50 to 40", "FALLOFF_START <= FALLOFF_END"},
    {"negative_opacity", "TEXDEF a AMBIENT 0 DIFFUSE 1 SPECULAR 0 OPACITY -1", "4: OPACITY is -1", "a number >= 0"},
    {"texfunc_fraction", TEXTURE_UP_TO_OPACITY "COLOR 1 1 1 TEXFUNC 0.5", "6: expected a whole number for TEXFUNC, found '0.5'",
     "whole"},
    {"zoom", CAMERA_WITH("ZOOM 0"), "5: ZOOM is 0", "above 0"},
    {"aspect", CAMERA_WITH("ZOOM 1\nASPECTRATIO -1"), "6: ASPECTRATIO is -1", "above 0"},
    {"samples", CAMERA_WITH("ZOOM 1 ASPECTRATIO 1 ANTIALIASING -1"), "5: -1 is out of range for ANTIALIASING", "from 0"},
    {"depth", CAMERA_WITH("ZOOM 1 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH x"),
     "5: expected a whole number for RAYDEPTH, found 'x'", "from 0"},
    {"view_zero", "CAMERA ZOOM 1 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 1 CENTER 0 0 0 VIEWDIR 0 0 0 UPDIR 0 1 0 END_CAMERA",
     "4: the camera's view and up directions do not span a plane", "not parallel"},
    {"view_parallel",
     "CAMERA ZOOM 1 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 1 CENTER 0 0 0 VIEWDIR 0 2 0 UPDIR 0 -1 0 END_CAMERA",
     "4: the camera's view and up directions do not span a plane", "not parallel"},
    {"no_points", "POLYCYLINDER POINTS 0 RAD 1 a", "4: 0 is out of range for POINTS", "from 1"},
    {"index", "VERTEXARRAY NUMVERTS 3 COORDS 0 0 0 1 0 0 0 1 0 NORMALS 0 0 1 0 0 1 0 0 1 TRIMESH 1 0 1 3 END_VERTEXARRAY",
     "4: a triangle of the vertices 0, 1 and 3 is outside its VERTEXARRAY", "below NUMVERTS"},
    {"negative_index", "VERTEXARRAY NUMVERTS 3 COORDS 0 0 0 1 0 0 0 1 0 NORMALS 0 0 1 0 0 1 0 0 1 TRIMESH 1 0 1 -1",
     "4: -1 is out of range for TRIMESH", "from 0"},

    // Counts that exceed the file must fail at its end, without allocating memory for the count.
    {"huge_points", "POLYCYLINDER POINTS 2000000000 0 0 0", "5: expected a number for POLYCYLINDER's points, found 'END_SCENE'",
     ""},
    {"huge_vertices", "VERTEXARRAY NUMVERTS 2000000000 COORDS 0 0 0", "5: expected a number for COORDS, found 'END_SCENE'", ""},
    {"huge_mesh", "VERTEXARRAY NUMVERTS 1 COORDS 0 0 0 NORMALS 0 0 1 TRIMESH 2000000000 0 0 0",
     "5: expected a whole number for TRIMESH, found 'END_SCENE'", ""},
    {"huge_strip", "VERTEXARRAY NUMVERTS 1 COORDS 0 0 0 NORMALS 0 0 1 TRISTRIP 2000000000 0 0 0",
     "5: expected a whole number for TRISTRIP, found 'END_SCENE'", ""},

    {"include_missing", "INCLUDE no.inc", "4: no.inc does not exist", ""},
    {"include_outside", "INCLUDE ../a.dat", "4: '../a.dat' is outside the scene's folder", "`asset-root` DIR"},
    {"include_folder", "INCLUDE .", "4: . is not a regular file", ""},
    {"tpoly_outside", "TPOLYFILE SCALE 1 1 1 ROT 0 0 0 CENTER 0 0 0\nFILE /etc/passwd a",
     "5: '/etc/passwd' is outside the scene's folder", "`asset-root` DIR"},
};

INSTANTIATE_TEST_SUITE_P(All, TachyonBadStatement, testing::ValuesIn(kBad),
                         [](const auto& bad) { return std::string(bad.param.name); });

TEST_F(Tachyon, file_without_begin_scene_is_an_error) {
  EXPECT_EQ(files.error_of("# comment\nCAMERA"), "scene.dat:2: expected BEGIN_SCENE, found 'CAMERA'");
}

TEST_F(Tachyon, empty_file_is_an_error) { EXPECT_EQ(files.error_of(""), "scene.dat:1: the file ends, expected BEGIN_SCENE"); }

TEST_F(Tachyon, resolution_must_follow_and_be_sane) {
  EXPECT_THAT(files.error_of("BEGIN_SCENE\nRESOLUTION 0 4"), StartsWith("scene.dat:2: 0 is out of range for RESOLUTION"));
  EXPECT_THAT(files.error_of("BEGIN_SCENE\nRESOLUTION 4 1000000000"),
              AllOf(StartsWith("scene.dat:2: 1000000000 is out of range for RESOLUTION"), HasSubstr("1 to 65536")));
}

TEST_F(Tachyon, file_without_end_scene_is_an_error) {
  EXPECT_EQ(files.error_of(TachyonFiles::kPrelude), "scene.dat:4: the file ends, expected END_SCENE");
}

TEST_F(Tachyon, what_follows_end_scene_is_ignored) {
  EXPECT_EQ(files.error_of(TachyonFiles::kPrelude + "END_SCENE FROG"), "no error");
}

TEST_F(Tachyon, scene_cut_anywhere_is_an_error) {
  files.write("a.tpoly", "3 0 0 0 1 0 0 0 1 0");
  const std::string scene = TachyonFiles::kPrelude + kTexture +
                            "OPACITY 1 PHONG METAL 1 PHONG_SIZE 2 COLOR 1 1 1 TEXFUNC 0\n"
                            "LIGHT CENTER 0 0 0 RAD 1 ATTENUATION CONSTANT 1 LINEAR 0 QUADRATIC 0 COLOR 1 1 1\n"
                            "STRI V0 0 0 0 V1 1 0 0 V2 0 1 0 N0 0 0 1 N1 0 0 1 N2 0 0 1 a\n"
                            "VERTEXARRAY NUMVERTS 3 COORDS 0 0 0 1 0 0 0 1 0 NORMALS 0 0 1 0 0 1 0 0 1 TRISTRIP 3 0 1 2 "
                            "END_VERTEXARRAY POLYCYLINDER POINTS 2 0 0 0 1 1 1 RAD 1 a\n"
                            "IMAGEDEF i FORMAT RGB24 RESOLUTION 1 1 1 ENCODING HEX 123456\n"
                            "TPOLYFILE SCALE 1 1 1 ROT 0 0 0 CENTER 0 0 0 FILE a.tpoly a\n";
  EXPECT_EQ(files.error_of(scene + "END_SCENE"), "no error");
  for (std::size_t length = 0; length < scene.size(); ++length)
    EXPECT_THAT(files.error_of(scene.substr(0, length)), testing::ContainsRegex("^[a-z.]+:[0-9]+: ")) << length;
}

TEST_F(Tachyon, folder_as_scene_is_an_error) {
  std::filesystem::create_directory(files.path("scene.dat"));
  EXPECT_THROW(files.load(), Error);
}

TEST_F(Tachyon, device_as_scene_is_an_error) {
  std::filesystem::create_symlink("/dev/zero", files.path("scene.dat"));
  try {
    files.load();
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("is not a regular file"));
  }
}

TEST_F(Tachyon, too_large_file_is_not_read) {
  files.write("scene.dat", "BEGIN_SCENE");
  // The file is sparse, so it takes no space.
  std::filesystem::resize_file(files.path("scene.dat"), (std::uintmax_t{1} << 30) + 1);
  try {
    files.load();
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("at most 1 GiB of text"));
  }
}

}  // namespace
}  // namespace lippmann
