#include "tachyon_support.hpp"

namespace lippmann {
namespace {

using test::phong;
using test::Tachyon;
using test::xyz;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kPlain = "AMBIENT 0.1 DIFFUSE 0.2 SPECULAR 0.3 OPACITY 0.4 ";

TEST_F(Tachyon, texture_without_phong_has_no_highlight) {
  const Scene scene = files.load_statements("SPHERE CENTER 0 0 0 RAD 1 TEXTURE " + kPlain + "COLOR 0.5 0.6 0.7 TEXFUNC 0");
  const PhongSurface& surface = phong(scene.materials[0]);
  EXPECT_EQ(surface.ambient, 0.1f);
  EXPECT_EQ(surface.diffuse, 0.2f);
  EXPECT_EQ(surface.mirror, 0.3f);
  EXPECT_EQ(surface.opacity, 0.4f);
  EXPECT_EQ(xyz(surface.color), (std::array{0.5f, 0.6f, 0.7f}));
  EXPECT_EQ(surface.highlight_kind, Highlight::kNone);
  EXPECT_EQ(surface.ior, 1.0f);
  EXPECT_EQ(surface.texture, -1);
}

TEST_F(Tachyon, phong_metal_and_plastic_are_told_apart) {
  const Scene scene = files.load_statements("TEXDEF m " + kPlain + "PHONG METAL 0.8 PHONG_SIZE 20 COLOR 1 1 1 TEXFUNC 0\n" +
                                            "TEXDEF p " + kPlain + "phong plastic 0.7 phong_size 30 color 1 1 1 texfunc 0");
  EXPECT_EQ(phong(scene.materials[0]).highlight_kind, Highlight::kMetal);
  EXPECT_EQ(phong(scene.materials[0]).highlight, 0.8f);
  EXPECT_EQ(phong(scene.materials[0]).highlight_size, 20.0f);
  EXPECT_EQ(phong(scene.materials[1]).highlight_kind, Highlight::kPlastic);
  EXPECT_EQ(phong(scene.materials[1]).highlight_size, 30.0f);
}

TEST_F(Tachyon, opacity_above_one_is_opaque) {
  const Scene scene = files.load_statements("TEXDEF a AMBIENT 0 DIFFUSE 1 SPECULAR 0 OPACITY 8.1 COLOR 1 1 1 TEXFUNC 0");
  EXPECT_EQ(phong(scene.materials[0]).opacity, 1.0f);
}

TEST_F(Tachyon, options_that_change_nothing_are_read) {
  const Scene scene =
      files.load_statements("TEXDEF a " + kPlain + "TRANSMODE ORIG OUTLINE 0 OUTLINE_WIDTH 0.3 COLOR 1 1 1 TEXFUNC 0");
  EXPECT_EQ(scene.materials.size(), 1u);
}

TEST_F(Tachyon, texture_names_distinguish_case) {
  const Scene scene = files.load_statements("TEXDEF a " + kPlain + "COLOR 1 0 0 TEXFUNC 0 TEXDEF A " + kPlain +
                                            "COLOR 0 1 0 TEXFUNC 0 SPHERE CENTER 0 0 0 RAD 1 A");
  EXPECT_EQ(scene.instances[0].material, 1);
  EXPECT_EQ(scene.materials[1].name, "A");
}

TEST_F(Tachyon, equal_textures_are_one_material) {
  const Scene scene = files.load_statements("TEXDEF a " + kPlain + "COLOR 1 0 0 TEXFUNC 0 SPHERE CENTER 0 0 0 RAD 1 TEXTURE " +
                                            kPlain + "COLOR 1 0 0 TEXFUNC 0");
  EXPECT_EQ(scene.materials.size(), 1u);
}

TEST_F(Tachyon, texalias_is_another_name) {
  const Scene scene =
      files.load_statements("TEXDEF a " + kPlain + "COLOR 1 0 0 TEXFUNC 0 TEXALIAS b a SPHERE CENTER 0 0 0 RAD 1 b");
  EXPECT_EQ(scene.instances[0].material, 0);
  EXPECT_THAT(files.warnings, IsEmpty());
}

TEST_F(Tachyon, first_texture_definition_applies) {
  const Scene scene = files.load_statements("TEXDEF a " + kPlain + "COLOR 1 0 0 TEXFUNC 0\nTEXDEF a " + kPlain +
                                            "COLOR 0 1 0 TEXFUNC 0\nSPHERE CENTER 0 0 0 RAD 1 a");
  EXPECT_EQ(scene.instances[0].material, 0);
  EXPECT_THAT(files.warnings, ElementsAre(HasSubstr("scene.dat:5: 'a' (and possibly others) is redefined")));
}

TEST_F(Tachyon, undefined_texture_is_white) {
  const Scene scene = files.load_statements("SPHERE CENTER 0 0 0 RAD 1 nowhere\nSPHERE CENTER 1 0 0 RAD 1 neither");
  EXPECT_EQ(xyz(phong(scene.materials[0]).color), (std::array{1.0f, 1.0f, 1.0f}));
  EXPECT_EQ(phong(scene.materials[0]).ambient, 0.1f);
  EXPECT_EQ(phong(scene.materials[0]).diffuse, 0.9f);
  EXPECT_THAT(files.warnings,
              ElementsAre(HasSubstr("scene.dat:4: the texture 'nowhere' (and possibly others) is not defined")));
}

const std::string kMapping = " CENTER 1 2 3 ROTATE 4 5 6 SCALE 7 8 9 UAXIS 1 0 2 VAXIS 0 1 3 ";

std::string planar(const std::string& file) {
  return "TEXDEF t AMBIENT 0 DIFFUSE 1 SPECULAR 0 OPACITY 1 COLOR 1 1 1 TEXFUNC 9 " + file + kMapping;
}

/// 1 x 2 pixels: red above blue.
const std::string kPpm = std::string("P6\n1 2\n255\n") + "\xff" + std::string(2, '\0') + std::string(2, '\0') + "\xff";

std::string tga(bool top_first) {
  std::string header(18, '\0');
  header[2] = 2, header[12] = 1, header[14] = 2, header[16] = 24, header[17] = top_first ? 0x20 : 0;
  const std::string red("\0\0\xff", 3), blue("\xff\0\0", 3);  // blue, green, red
  return header + (top_first ? red + blue : blue + red);
}

std::vector<int> rgba(const Texture& texture) { return {texture.rgba.begin(), texture.rgba.end()}; }

TEST_F(Tachyon, planar_mapping_is_mirrored) {
  files.write("imaps/a.ppm", kPpm);
  const Scene scene = files.load_statements(planar("imaps/a.ppm"));
  const PhongSurface& surface = phong(scene.materials[0]);
  ASSERT_TRUE(surface.projection);
  EXPECT_EQ(surface.projection->kind, ProjectionKind::kPlane);
  EXPECT_EQ(xyz(surface.projection->center), (std::array{1.0f, 2.0f, -3.0f}));
  EXPECT_EQ(xyz(surface.projection->rotate), (std::array{4.0f, 5.0f, 6.0f}));
  EXPECT_EQ(xyz(surface.projection->scale), (std::array{7.0f, 8.0f, 9.0f}));
  EXPECT_EQ(xyz(surface.projection->u_axis), (std::array{1.0f, 0.0f, -2.0f}));
  EXPECT_EQ(xyz(surface.projection->v_axis), (std::array{0.0f, 1.0f, -3.0f}));
}

TEST_F(Tachyon, cylindrical_and_spherical_images_stand_along_y) {
  files.write("a.ppm", kPpm);
  const std::string start = " AMBIENT 0 DIFFUSE 1 SPECULAR 0 OPACITY 1 COLOR 1 1 1 TEXFUNC ";
  const std::string end = " a.ppm CENTER 1 2 3 ROTATE 4 5 6 SCALE 7 8 9 ";
  const Scene scene = files.load_statements("TEXDEF c" + start + "7" + end + "TEXDEF s" + start + "8" + end);
  ASSERT_EQ(scene.materials.size(), 2u);
  const ImageProjection &cylinder = *phong(scene.materials[0]).projection, &sphere = *phong(scene.materials[1]).projection;
  EXPECT_EQ(cylinder.kind, ProjectionKind::kCylinder);
  EXPECT_EQ(sphere.kind, ProjectionKind::kSphere);
  EXPECT_EQ(xyz(cylinder.center), (std::array{1.0f, 2.0f, -3.0f}));
  EXPECT_EQ(xyz(cylinder.rotate), (std::array{4.0f, 5.0f, 6.0f}));
  EXPECT_EQ(xyz(cylinder.scale), (std::array{7.0f, 8.0f, 9.0f}));
  EXPECT_EQ(xyz(cylinder.u_axis), (std::array{1.0f, 0.0f, 0.0f}));
  EXPECT_EQ(xyz(cylinder.v_axis), (std::array{0.0f, 1.0f, 0.0f}));
}

TEST_F(Tachyon, ppm_top_row_is_v_0) {
  files.write("a.ppm", kPpm);
  const Scene scene = files.load_statements(planar("a.ppm"));
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].width, 1);
  EXPECT_EQ(scene.textures[0].height, 2);
  EXPECT_FALSE(scene.textures[0].srgb);
  EXPECT_THAT(rgba(scene.textures[0]), ElementsAre(255, 0, 0, 255, 0, 0, 255, 255));
}

TEST_F(Tachyon, tga_bottom_row_is_v_0) {
  for (const bool top_first : {true, false}) {
    files.write("a.tga", tga(top_first));
    const Scene scene = files.load_statements(planar("a.tga"));
    EXPECT_THAT(rgba(scene.textures[0]), ElementsAre(0, 0, 255, 255, 255, 0, 0, 255)) << top_first;
  }
}

TEST_F(Tachyon, image_used_twice_is_read_once) {
  files.write("a.ppm", kPpm);
  const Scene scene = files.load_statements(planar("a.ppm") +
                                            "SPHERE CENTER 0 0 0 RAD 1 TEXTURE AMBIENT 1 DIFFUSE 1 SPECULAR 0 "
                                            "OPACITY 1 COLOR 1 1 1 TEXFUNC 9 a.ppm" +
                                            kMapping);
  EXPECT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.materials.size(), 2u);
}

TEST_F(Tachyon, missing_image_is_white_with_a_warning) {
  const Scene scene = files.load_statements(planar("imaps/no.ppm"));
  EXPECT_EQ(scene.textures[0].rgba, std::vector<std::uint8_t>(64, 255));
  EXPECT_THAT(files.warnings, ElementsAre("scene.dat:4: the image map 'imaps/no.ppm' does not exist; white is shown."));
}

TEST_F(Tachyon, broken_image_reports_the_line) {
  files.write("a.ppm", "P6 1000 1000 255 xyz");
  EXPECT_THAT(files.error_of_statements(planar("a.ppm")),
              testing::StartsWith("scene.dat:4: the image map cannot be used: a.ppm"));
}

TEST_F(Tachyon, image_of_another_kind_is_an_error) {
  files.write("a.txt", "text");
  EXPECT_THAT(files.error_of_statements(planar("a.txt")),
              HasSubstr("scene.dat:4: 'a.txt' has an unsupported image map format"));
}

TEST_F(Tachyon, outside_picture_is_white) {
  std::filesystem::create_directory(files.path("below"));
  std::filesystem::create_symlink("/", files.path("link"));
  for (const std::string name : {"/etc/passwd.ppm", "../a.ppm", "below/../../a.ppm", "link/etc/passwd.ppm", ".."}) {
    files.warnings.clear();
    const Scene scene = files.load_statements(planar(name));
    EXPECT_THAT(files.warnings, ElementsAre(testing::AllOf(HasSubstr("'" + name + "' is outside the scene's folder"),
                                                           HasSubstr("`asset-root` DIR"))));
    EXPECT_EQ(scene.textures.at(0).rgba.at(0), 255);
  }
}

TEST_F(Tachyon, imagedef_accepts_all_digit_widths) {
  const Scene scene = files.load_statements(
      "IMAGEDEF ::mine FORMAT RGB24 RESOLUTION 2 2 1 ENCODING HEX f0a 102030 123456789 FFFF80000000\n" + planar("::mine"));
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].name, "::mine");
  EXPECT_THAT(rgba(scene.textures[0]), ElementsAre(255, 0, 170, 255, 16, 32, 48, 255, 0x12, 0x45, 0x78, 255, 255, 128, 0, 255));
  EXPECT_EQ(phong(scene.materials[0]).texture, 0);
}

TEST_F(Tachyon, volume_imagedef_is_an_error) {
  EXPECT_THAT(files.error_of_statements("IMAGEDEF v FORMAT RGB24 RESOLUTION 4 4 4 ENCODING HEX"),
              HasSubstr("scene.dat:4: IMAGEDEF 'v' is a volume, which is not supported"));
}

TEST_F(Tachyon, too_few_imagedef_pixels_are_an_error) {
  EXPECT_THAT(files.error_of_statements("IMAGEDEF v FORMAT RGB24 RESOLUTION 60000 60000 1 ENCODING HEX fff 000"),
              HasSubstr("scene.dat:5: 'END_SCENE' is not a colour"));
}

}  // namespace
}  // namespace lippmann
