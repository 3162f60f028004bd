#include <gtest/gtest.h>

#include <fstream>

#include "frames/frame.hpp"
#include "image/read_image.hpp"
#include "job/job_stage.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/image/metrics.hpp"
#include "support/command.hpp"
#include "support/image_compare.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

const fs::path kScenes = "/usr/share/doc/tachyon/examples/scenes";

Image8 our_picture(const fs::path& scene, Vec2i size, const fs::path& camera_path = {}, int frame = 0) {
  RenderParams params;
  params.scene.name = scene.string();
  params.scene.camera_path = camera_path.string();
  params.optics.kind = OpticsKind::kSingle;
  params.optics.size = {size.x, size.y};
  const ThreadPool pool(2);
  const Context context;
  JobStage stage(ResolvedJob(params), pool, context);
  return to_codes(render_frame(stage, params.sampling, frame, pool, context).pictures.film, stage.scene.encoding);
}

/// Runs tachyon in the scene's folder, where it looks for images. With a camera path, `picture` is a file name pattern.
void run_tachyon(const fs::path& scene, Vec2i size, const fs::path& picture, const std::string& options = {}) {
  const std::string command = "cd '" + scene.parent_path().string() + "' && tachyon '" + scene.filename().string() + "' -res " +
                              std::to_string(size.x) + " " + std::to_string(size.y) +
                              " -aasamples 0 -numthreads 2 -format PPM -o '" + picture.string() + "' " + options;
  const test::CommandResult result = test::run_command(command);
  ASSERT_EQ(result.exit_code, 0) << result.output;
}

Image8 tachyon_picture(const fs::path& scene, Vec2i size) {
  const test::TempDir dir;
  run_tachyon(scene, size, dir / "picture.ppm");
  return read_image8(dir / "picture.ppm");
}

bool tachyon_is_missing() { return !test::program_exists("tachyon"); }

struct Example {
  const char* name;
  double least_db;
};
void PrintTo(const Example& example, std::ostream* out) { *out << example.name; }

class TachyonReference : public testing::TestWithParam<Example> {};

/// The tolerances allow for rounding, which moves silhouettes by a pixel, grows in chains of mirrors, and affects
/// images on huge spheres.
TEST_P(TachyonReference, picture_agrees) {
  if (tachyon_is_missing()) GTEST_SKIP() << "the program tachyon is not installed";
  const fs::path scene = kScenes / (std::string(GetParam().name) + ".dat");
  if (!fs::exists(scene)) GTEST_SKIP() << "the package tachyon-doc is not installed";
  const Vec2i size(512, 512);
  const Image8 reference = tachyon_picture(scene, size), ours = our_picture(scene, size);
  const double psnr = measure_difference(reference, ours).psnr_db;
  EXPECT_GE(psnr, GetParam().least_db) << test::detail::leave_evidence(ours, reference);
  RecordProperty("psnr_db", std::to_string(psnr));
}

INSTANTIATE_TEST_SUITE_P(Paper, TachyonReference,
                         testing::Values(Example{"room", 50.0}, Example{"smallballs", 50.0}, Example{"teapot", 50.0}),
                         [](const auto& example) { return std::string(example.param.name); });

INSTANTIATE_TEST_SUITE_P(Others, TachyonReference,
                         testing::Values(Example{"2balls", 30.0}, Example{"820spheres", 30.0}, Example{"attenuation", 30.0},
                                         Example{"balls", 30.0}, Example{"dna", 30.0}, Example{"gridtest", 30.0},
                                         Example{"island", 30.0}, Example{"janbadoutput", 30.0}, Example{"lame", 30.0},
                                         Example{"lattice", 30.0}, Example{"lavablobs", 30.0}, Example{"msti", 30.0},
                                         Example{"null", 30.0}, Example{"null2", 30.0}, Example{"polycyl", 30.0},
                                         Example{"space", 30.0}, Example{"spotlight", 30.0}, Example{"tetra", 30.0},
                                         Example{"texfree", 30.0}, Example{"tpolytest", 30.0}, Example{"transtest", 30.0},
                                         Example{"trypsin4pti", 30.0}, Example{"umr", 30.0}, Example{"umrfrustum", 30.0}),
                         [](const auto& example) { return "scene_" + std::string(example.param.name); });

const std::string kCamera =
    "CAMERA ZOOM 1 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 6 CENTER 0 2 -6 VIEWDIR 0 -0.3 1 UPDIR 0.1 1 0 END_CAMERA\n";

std::string texture(const std::string& properties) { return " TEXTURE AMBIENT 0.1 " + properties + " TEXFUNC 0\n"; }

const std::string kFloor = "PLANE CENTER 0 -1 0 NORMAL 0 1 0" + texture("DIFFUSE 0.8 SPECULAR 0 OPACITY 1 COLOR 0.9 0.8 0.7");
const std::string kVeil = texture("DIFFUSE 0.6 SPECULAR 0 OPACITY 0.4 PHONG PLASTIC 0.5 PHONG_SIZE 30 COLOR 0.2 0.5 1");
const std::string kMirror = texture("DIFFUSE 0.2 SPECULAR 0.7 OPACITY 1 COLOR 0.6 1 0.6");

struct Rule {
  const char* name;
  std::string statements;
};
void PrintTo(const Rule& rule, std::ostream* out) { *out << rule.name; }

class TachyonRule : public testing::TestWithParam<Rule> {
 protected:
  void SetUp() override {
    if (tachyon_is_missing()) GTEST_SKIP() << "the program tachyon is not installed";
  }
  void write(const std::string& name, const std::string& contents) const {
    std::ofstream(dir_ / name, std::ios::binary) << contents;
  }
  test::TempDir dir_;
};

/// Single and double precision differ by up to 2 codes, and silhouettes by more.
constexpr test::ImageTolerance kTolerance{.per_pixel = 2, .share = 0.005};

/// 13 x 6 different pixels. Tachyon treats sides that are not powers of two differently.
std::string small_ppm() {
  std::string ppm = "P6\n13 6\n255\n";
  for (int i = 0; i < 13 * 6; ++i)
    for (const int step : {37, 83, 151}) ppm += static_cast<char>(i * step % 256);
  return ppm;
}

/// 16 x 8 pixels, the bottom row first.
std::string small_tga() {
  std::string tga(18, '\0');
  tga[2] = 2, tga[12] = 16, tga[14] = 8, tga[16] = 24;
  for (int i = 0; i < 16 * 8; ++i)
    for (const int step : {29, 71, 113}) tga += static_cast<char>(i * step % 256);
  return tga;
}

TEST_P(TachyonRule, is_followed) {
  write("a.ppm", small_ppm());
  write("a.tga", small_tga());
  write("a.tpoly", "3 0 0 0 1 0 0 0 1 0.5\n3 0 0 0 0 1 0.5 0 0 1\n");
  write("scene.dat", "BEGIN_SCENE\nRESOLUTION 160 120\n" + kCamera + GetParam().statements + "\nEND_SCENE\n");
  const Vec2i size(160, 120);
  const Image8 reference = tachyon_picture(dir_ / "scene.dat", size);
  EXPECT_TRUE(test::images_match(our_picture(dir_ / "scene.dat", size), reference, kTolerance));
}

const std::string kPointLight = "LIGHT CENTER 3 5 -4 RAD 0.2 COLOR 0.8 0.7 0.6\n";

const Rule kRules[] = {
    {"background", "BACKGROUND 0.2 0.4 0.6"},
    {"directional_lights_shine_and_cast_shadows",
     kFloor + "DIRECTIONAL_LIGHT DIRECTION 1 -2 1 COLOR 0.7 0.6 0.5 DIRECTIONAL_LIGHT DIRECTION -1 -1 0.2 COLOR 0.1 0.2 0.3\n" +
         "SPHERE CENTER 0 0 0 RAD 1" +
         texture("DIFFUSE 0.5 SPECULAR 0 OPACITY 1 PHONG METAL 0.6 PHONG_SIZE 12 COLOR 1 0.6 0.3")},
    {"spot_light_falls_off_with_the_angle",
     kFloor + "SPOTLIGHT CENTER 2 4 -1 RAD 0.3 DIRECTION -0.4 -1 0.2 FALLOFF_START 10 FALLOFF_END 40 COLOR 1 0.9 0.8\n" +
         "SPHERE CENTER 0.3 0 0 RAD 0.8" +
         texture("DIFFUSE 0.5 SPECULAR 0 OPACITY 1 PHONG PLASTIC 0.9 PHONG_SIZE 40 COLOR 1 0 0")},
    {"spot_light_without_a_soft_edge",
     kFloor + "SPOTLIGHT CENTER 2 4 -1 RAD 0.3 DIRECTION -0.4 -1 0.2 FALLOFF_START 25 FALLOFF_END 25 COLOR 1 0.9 0.8"},
    {"plastic_and_metal_highlights",
     kFloor + kPointLight + "LIGHT CENTER -4 2 -5 RAD 0 COLOR 0.2 0.3 0.6\nSPHERE CENTER -1.5 0 0 RAD 1" +
         texture("DIFFUSE 0.3 SPECULAR 0 OPACITY 1 PHONG METAL 0.9 PHONG_SIZE 8 COLOR 1 0.5 0.2") +
         "SPHERE CENTER 1.5 0 0 RAD 1" +
         texture("DIFFUSE 0.3 SPECULAR 0 OPACITY 1 PHONG PLASTIC 0.9 PHONG_SIZE 25 COLOR 1 0.5 0.2")},
    {"lights_are_seen_directly_and_in_mirrors", kFloor +
                                                    "LIGHT CENTER 1 1 0 RAD 0.5 COLOR 1 0.5 0.2\nLIGHT CENTER -1 1 2 RAD 0.3 "
                                                    "COLOR 0.2 1 0.5\nSPHERE CENTER -0.5 0 3 RAD 1" +
                                                    kMirror},
    {"light_behind_glass_dims_with_every_crossing",
     kFloor + "LIGHT CENTER 0 6 0 RAD 0.1 COLOR 1 1 1\nSPHERE CENTER -2 1 0 RAD 0.8" + kVeil +
         "BOX MIN 1 0.5 -1 MAX 2.5 1.5 1" + kVeil + "FCYLINDER BASE -0.8 1.5 1 APEX 0.8 1.5 2 RAD 0.4" + kVeil +
         "RING CENTER 0 2 0 NORMAL 0 1 0.2 INNER 0.2 OUTER 0.7" + kVeil + "TRI V0 -3 0 2 V1 -1 0 3 V2 -2 1.5 3" + kVeil},
    {"see_through_plane_weakens_light",
     kFloor + "LIGHT CENTER 0 6 0 RAD 0.1 COLOR 1 1 1\nPLANE CENTER 0 1 0 NORMAL 0 1 0" + kVeil},
    {"depth_limit_shows_the_background_whole", "BACKGROUND 0.1 0.2 0.3\n" + kPointLight + kFloor +
                                                   "PLANE CENTER 0 0 4 NORMAL 0 0 1" + kMirror +
                                                   "PLANE CENTER 0 0 -8 NORMAL 0 0 1" + kMirror},
    {"depth_limit_behind_veils", "BACKGROUND 0.1 0.2 0.3\n" + kPointLight + kFloor +
                                     [] {
                                       std::string veils;
                                       for (int z = 0; z < 8; ++z)
                                         veils +=
                                             "RING CENTER 0 0 " + std::to_string(z) + " NORMAL 0 0 1 INNER 0 OUTER 1.5" + kVeil;
                                       return veils;
                                     }()},
    {"long_box_has_tachyon_s_normals",
     kFloor + kPointLight + "BOX MIN -2.5 -0.6 0 MAX 2 0.7 1" + texture("DIFFUSE 0.9 SPECULAR 0 OPACITY 1 COLOR 1 1 1")},
    {"ring_cylinder_polycylinder", kFloor + kPointLight + "RING CENTER -1.5 0.5 1 NORMAL 0.3 0.5 -1 INNER 0.3 OUTER 1" +
                                       kMirror + "FCYLINDER BASE 0 0 0 APEX 1 1 1 RAD 0.4" +
                                       texture("DIFFUSE 0.9 SPECULAR 0 OPACITY 1 COLOR 1 1 0") +
                                       "POLYCYLINDER POINTS 3 1 0 2 2 1 2 3 0 3 RAD 0.3" + kMirror},
    {"smooth_and_flat_triangles",
     kFloor + kPointLight + "STRI V0 -2 0 0 V1 0 0 1 V2 -1 1.5 0 N0 -0.7 0.2 -0.7 N1 0.6 0 -0.8 N2 0 0.8 -0.6" +
         texture("DIFFUSE 0.9 SPECULAR 0 OPACITY 1 PHONG PLASTIC 0.4 PHONG_SIZE 15 COLOR 1 1 0") +
         "TRI V0 0.5 0 0 V1 2 0 1 V2 1 1.5 0" + texture("DIFFUSE 0.9 SPECULAR 0 OPACITY 1 COLOR 0 1 1")},
    {"smooth_triangle_wound_against_its_normals",
     kFloor + kPointLight + "STRI V0 -1 1.5 0 V1 0 0 1 V2 -2 0 0 N0 0 0.8 -0.6 N1 0.6 0 -0.8 N2 -0.7 0.2 -0.7" +
         texture("DIFFUSE 0.9 SPECULAR 0 OPACITY 1 COLOR 1 1 0")},
    {"vertex_array_of_strips",
     kFloor + kPointLight +
         "VERTEXARRAY NUMVERTS 5 COORDS -2 0 0 -1 1 0 0 0 0.5 1 1 1 2 0 1 NORMALS 0 0 -1 0 0.3 -1 0 0 -1 0.2 0.3 -1 0 0 -1 "
         "TEXTURE AMBIENT 0.1 "
         "DIFFUSE 0.8 SPECULAR 0 OPACITY 1 COLOR 1 0.4 0.4 TEXFUNC 0 TRISTRIP 5 0 1 2 3 4 END_VERTEXARRAY"},
    {"tpolyfile_turned_about_all_axes", kFloor + kPointLight +
                                            "TPOLYFILE SCALE 2 1.5 1 ROT 20 30 40 CENTER -0.5 0 0 FILE a.tpoly" +
                                            texture("DIFFUSE 0.9 SPECULAR 0 OPACITY 1 COLOR 1 1 0")},
    {"planar_image_maps_at_all_distances", kPointLight + "PLANE CENTER 0 -1 0 NORMAL 0 1 0 TEXTURE AMBIENT 0.5 DIFFUSE 0.5 "
                                                         "SPECULAR 0.2 OPACITY 1 COLOR 1 1 1 TEXFUNC 9 a.ppm CENTER 0.3 0 0.2 "
                                                         "ROTATE 0.1 0.2 0 SCALE 0.2 -0.3 5 UAXIS 1 0 0 VAXIS 0 0 1\n"
                                                         "PLANE CENTER 0 0 8 NORMAL 0 0 1 TEXTURE AMBIENT 0.5 DIFFUSE 0.5 "
                                                         "SPECULAR 0 OPACITY 1 COLOR 1 1 1 TEXFUNC 9 a.tga CENTER 0 0 0 ROTATE "
                                                         "0 0 0 SCALE 0.11 0.07 0 UAXIS 1 0.3 0 VAXIS 0 1 0"},
    {"cylindrical_and_spherical_image_maps", kPointLight +
                                                 "SPHERE CENTER -1.3 0.5 1 RAD 1.2 TEXTURE AMBIENT 0.5 DIFFUSE 0.5 SPECULAR "
                                                 "0.2 OPACITY 1 COLOR 1 1 1 TEXFUNC 7 a.ppm CENTER -1.3 0.2 1 "
                                                 "ROTATE 0.1 0.2 0 SCALE 2 -0.7 5\n"
                                                 "SPHERE CENTER 1.3 0.5 1 RAD 1.2 TEXTURE AMBIENT 0.5 DIFFUSE 0.5 SPECULAR 0 "
                                                 "OPACITY 1 COLOR 1 1 1 TEXFUNC 8 a.tga CENTER 1.3 0.5 1 ROTATE 0.3 0 0 "
                                                 "SCALE 1 2 0"},
    {"attenuated_lights", kFloor +
                              "LIGHT CENTER 1 1 0 RAD 0.1 ATTENUATION CONSTANT 0.5 LINEAR 0.2 QUADRATIC 0.3 COLOR 1 0.9 "
                              "0.8\nSPOTLIGHT CENTER -2 3 1 RAD 0.1 DIRECTION "
                              "0.2 -1 0 FALLOFF_START 20 FALLOFF_END 40 ATTENUATION CONSTANT 0 LINEAR 0 QUADRATIC 0.2 COLOR "
                              "0.3 0.5 1\nSPHERE CENTER 0 0 0 RAD 0.8" +
                              texture("DIFFUSE 0.5 SPECULAR 0 OPACITY 1 PHONG PLASTIC 0.9 PHONG_SIZE 20 COLOR 1 0.8 0.5")},
    {"background_gradient_is_seen_and_mirrored",
     "BACKGROUND_GRADIENT SKY_SPHERE UPDIR 0.2 1.5 0.1 TOPVAL 0.6 BOTTOMVAL -0.4 TOPCOLOR 0.1 0.2 0.9 BOTTOMCOLOR 0.9 0.5 "
     "0.1\n" +
         kPointLight + "SPHERE CENTER 0 1 0 RAD 1.5" + kMirror},
    {"vertex_colours", kFloor + kPointLight +
                           "VERTEXARRAY NUMVERTS 4 COORDS -2 0 0 -1 1.5 0 0 0 0.5 1 1.5 1 NORMALS 0 0 -1 0 0.3 -1 0 0 -1 0.2 "
                           "0.3 -1 COLORS 1 0 0 0 1 0 0 0 1 1 1 0 TEXTURE "
                           "AMBIENT 0.1 DIFFUSE 0.8 SPECULAR 0 OPACITY 1 PHONG METAL 0.5 PHONG_SIZE 10 COLOR 0.2 0.2 0.2 "
                           "TEXFUNC 0 TRISTRIP 4 0 1 2 3 END_VERTEXARRAY VCSTRI V0 1.5 0 0 "
                           "V1 2.5 0 1 V2 2 1.5 0 N0 0 0 -1 N1 0 0.3 -1 N2 0 0 -1 C0 1 0 1 C1 0 1 1 C2 1 1 0 AMBIENT 0.2 "
                           "DIFFUSE 0.7 SPECULAR 0 OPACITY 1 VCST"},
    {"fractal_landscape",
     kPointLight + "SCAPE RES 33 20 SCALE 12 10 CENTER 0 -2 4" + texture("DIFFUSE 0.9 SPECULAR 0 OPACITY 1 COLOR 1 0.9 0.6")},
    {"undefined_texture_is_matt_white", kFloor + kPointLight + "SPHERE CENTER 0 0 0 RAD 1 nowhere"},
    {"medium_shader_mode_has_no_shadows",
     kFloor + kPointLight + "DIRECTIONAL_LIGHT DIRECTION 1 -2 1 COLOR 0.4 0.4 0.4\nSHADER_MODE MEDIUM END_SHADER_MODE\n" +
         "SPHERE CENTER -1 1 0 RAD 1" + kMirror + "FCYLINDER BASE 1 0 0 APEX 2 1 1 RAD 0.4" + kVeil +
         "BOX MIN 1 1.5 -1 MAX 2.5 2 1" + kVeil + "TRI V0 -3 0 2 V1 -1 0 3 V2 -2 1.5 3" + kMirror},
    {"vmd_transparency_weighs_by_opacity", "BACKGROUND 0.1 0.2 0.3\nSHADER_MODE FULL TRANS_VMD FOG_VMD END_SHADER_MODE\n" +
                                               kFloor + kPointLight + "SPHERE CENTER -1 1 0 RAD 1" + kVeil +
                                               "SPHERE CENTER 0.5 1 2 RAD 1" + kVeil + "BOX MIN 1 0.5 -1 MAX 2.5 1.5 1" +
                                               kMirror},
    {"low_shader_mode_shows_plain_colours", "BACKGROUND 0.1 0.2 0.3\nSHADER_MODE LOW END_SHADER_MODE\n" + kFloor + kPointLight +
                                                "SPHERE CENTER -1 1 0 RAD 1" + kVeil + "SPHERE CENTER 0.5 1 2 RAD 1" + kMirror},
    {"last_camera_counts_and_its_frustum_is_used", kFloor + kPointLight +
                                                       "CAMERA ZOOM 2 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 3 CENTER 5 3 4 "
                                                       "VIEWDIR -2 -1 -1.5 UPDIR 0.2 1 0.1 FRUSTUM -0.4 0.4 -0.3 0.3 "
                                                       "END_CAMERA SPHERE CENTER 0 0 0 RAD 1" +
                                                       kMirror},
};

INSTANTIATE_TEST_SUITE_P(All, TachyonRule, testing::ValuesIn(kRules),
                         [](const auto& rule) { return std::string(rule.param.name); });

TEST_F(TachyonRule, camera_path_gives_the_same_frames) {
  const fs::path scene = dir_ / "scene.dat", path = dir_ / "scene.cam";
  write("scene.dat",
        "BEGIN_SCENE RESOLUTION 80 60 " + kCamera + kFloor + kPointLight + "SPHERE CENTER 0 0 0 RAD 1" + kMirror + "END_SCENE");
  write("scene.cam", "0 -0.21 1 0 1 0 0 1 -5\n0.3 -0.2 1 0.1 1 0 -1 1 -5\n0.5 -0.3 1 0.2 1 0 -2 2 -4\n");
  const Vec2i size(80, 60);
  run_tachyon(scene, size, dir_ / "frame%d.ppm", "-camfile '" + path.string() + "'");
  EXPECT_FALSE(fs::exists(dir_ / "frame4.ppm"));
  for (int frame = 0; frame < 4; ++frame)
    EXPECT_TRUE(test::images_match(our_picture(scene, size, path, frame),
                                   read_image8(dir_ / ("frame" + std::to_string(frame) + ".ppm")), kTolerance))
        << frame;
}

}  // namespace
}  // namespace lippmann
