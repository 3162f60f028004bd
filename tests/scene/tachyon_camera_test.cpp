#include <cmath>

#include "lippmann/scene/timeline.hpp"
#include "tachyon_support.hpp"

namespace lippmann {
namespace {

using test::Tachyon;
using test::TachyonFiles;
using test::xyz;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string camera(const std::string& pose, const std::string& zoom = "ZOOM 1") {
  return "CAMERA " + zoom + " ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 12 " + pose + " END_CAMERA\n";
}

struct CameraFrame {
  Vec3f origin, right, up, forward;
};
CameraFrame frame_of(const Scene& scene, double time = 0.0) {
  const Affine3f world_from_camera = evaluate(scene, time).of(scene.cameras.at(0).node);
  const auto axis = [&](Vec3f v) { return glm::round(transform_vector(world_from_camera, v) * 1e6f) / 1e6f + Vec3f(0.0f); };
  return {world_from_camera.translation, axis({1, 0, 0}), axis({0, 1, 0}), axis({0, 0, -1})};
}

/// In Tachyon's left-handed axes, view = +z, up = +y and right = cross(up, view) = +x. The reader mirrors z: view = -z,
/// up = +y, right = cross(view, up) = +x.
TEST_F(Tachyon, camera_along_z_looks_along_minus_z) {
  const Scene scene = files.load_statements(camera("CENTER 1 2 3 VIEWDIR 0 0 1 UPDIR 0 1 0"));
  const CameraFrame frame = frame_of(scene);
  EXPECT_EQ(xyz(frame.origin), (std::array{1.0f, 2.0f, -3.0f}));
  EXPECT_EQ(xyz(frame.right), (std::array{1.0f, 0.0f, 0.0f}));
  EXPECT_EQ(xyz(frame.up), (std::array{0.0f, 1.0f, 0.0f}));
  EXPECT_EQ(xyz(frame.forward), (std::array{0.0f, 0.0f, -1.0f}));
}

/// In Tachyon's left-handed axes, view = +x, up = +z and right = cross(up, view) = +y. The reader mirrors z: view = +x,
/// up = -z, right = cross(view, up) = +y.
TEST_F(Tachyon, camera_right_is_tachyon_s_right_mirrored) {
  const CameraFrame frame = frame_of(files.load_statements(camera("CENTER 0 0 0 VIEWDIR 3 0 0 UPDIR 0 0 2")));
  EXPECT_EQ(xyz(frame.right), (std::array{0.0f, 1.0f, 0.0f}));
  EXPECT_EQ(xyz(frame.up), (std::array{0.0f, 0.0f, -1.0f}));
  EXPECT_EQ(xyz(frame.forward), (std::array{1.0f, 0.0f, 0.0f}));
}

/// The part of up = (0, 1, 1) that is orthogonal to view = (0, 0, 1) is (0, 1, 0).
TEST_F(Tachyon, up_is_made_orthogonal_to_view) {
  const CameraFrame frame = frame_of(files.load_statements(camera("CENTER 0 0 0 VIEWDIR 0 0 1 UPDIR 0 1 1")));
  EXPECT_EQ(xyz(frame.up), (std::array{0.0f, 1.0f, 0.0f}));
}

/// Tachyon's samples lie half a pixel to the right of our pixel centres, and half a pixel above them.
TEST_F(Tachyon, pixel_offset_is_half_right_and_up) {
  const Scene scene = files.load_statements("");
  EXPECT_EQ(scene.cameras[0].pixel_offset.x, 0.5f);
  EXPECT_EQ(scene.cameras[0].pixel_offset.y, -0.5f);
}

TEST_F(Tachyon, zoom_1_sees_half_at_distance_1) {
  const Scene scene = files.load_statements("");
  EXPECT_NEAR(std::tan(scene.cameras[0].vertical_fov / 2), 0.5f, 1e-6f);  // the angle is rounded to float
}

TEST_F(Tachyon, zoom_2_halves_the_picture) {
  const Scene scene = files.load_statements(camera("CENTER 0 0 0 VIEWDIR 0 0 1 UPDIR 0 1 0", "ZOOM 2"));
  EXPECT_NEAR(std::tan(scene.cameras[0].vertical_fov / 2), 0.25f, 1e-6f);
}

TEST_F(Tachyon, projection_perspective_is_read) {
  const Scene scene = files.load_statements(camera("CENTER 0 0 0 VIEWDIR 0 0 1 UPDIR 0 1 0", "PROJECTION PERSPECTIVE ZOOM 2"));
  EXPECT_NEAR(std::tan(scene.cameras[0].vertical_fov / 2), 0.25f, 1e-6f);
}

TEST_F(Tachyon, symmetric_frustum_overrides_zoom) {
  const Scene scene =
      files.load_statements(camera("CENTER 0 0 0 VIEWDIR 0 0 1 UPDIR 0 1 0 FRUSTUM -0.8 0.8 -0.2 0.2", "ZOOM 3"));
  EXPECT_NEAR(std::tan(scene.cameras[0].vertical_fov / 2), 0.2f, 1e-6f);
  EXPECT_NEAR(scene.cameras[0].aspect, 4.0f, 1e-6f);
}

TEST_F(Tachyon, whole_scene_properties_are_tachyon_s) {
  const Scene scene = files.load_statements(camera("CENTER 0 0 0 VIEWDIR 0 0 1 UPDIR 0 1 0") + "BACKGROUND 0.1 0.2 0.3");
  EXPECT_EQ(scene.name, "scene");
  EXPECT_EQ(scene.resolution.x, 4);
  EXPECT_EQ(scene.resolution.y, 3);
  EXPECT_NEAR(scene.cameras[0].aspect, 4.0f / 3.0f, 1e-6f);
  EXPECT_EQ(scene.max_depth, 12);
  EXPECT_EQ(scene.encoding, Encoding::kTachyonTruncate);
  EXPECT_EQ(xyz(scene.background.horizon), (std::array{0.1f, 0.2f, 0.3f}));
  EXPECT_EQ(xyz(scene.background.zenith), (std::array{0.1f, 0.2f, 0.3f}));
  EXPECT_EQ(scene.timeline.frame_count, 1);
  EXPECT_FALSE(scene.display);
}

TEST_F(Tachyon, last_camera_applies) {
  const Scene scene = files.load_statements(camera("CENTER 9 9 9 VIEWDIR 0 0 1 UPDIR 0 1 0") +
                                            camera("CENTER 1 1 1 VIEWDIR 0 0 1 UPDIR 0 1 0"));
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(xyz(frame_of(scene).origin), (std::array{1.0f, 1.0f, -1.0f}));
  EXPECT_EQ(xyz(scene.background.horizon), (std::array{0.0f, 0.0f, 0.0f}));
}

TEST_F(Tachyon, raydepth_0_is_1) {
  const Scene scene = files.load_statements(
      "CAMERA ZOOM 1 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 0 CENTER 0 0 0 VIEWDIR 0 0 1 UPDIR 0 1 0 END_CAMERA");
  EXPECT_EQ(scene.max_depth, 1);
}

TEST_F(Tachyon, what_the_render_decides_is_a_warning) {
  files.load_statements(
      "CAMERA ZOOM 1 ASPECTRATIO 2 ANTIALIASING 8 RAYDEPTH 1 CENTER 0 0 0 VIEWDIR 0 0 1 UPDIR 0 1 0 END_CAMERA");
  EXPECT_THAT(files.warnings, ElementsAre(HasSubstr("scene.dat:4: ASPECTRATIO 2"), HasSubstr("scene.dat:4: ANTIALIASING 8")));
}

TEST_F(Tachyon, shader_mode_that_changes_nothing_is_read) {
  files.load_statements("SHADER_MODE FULL SHADOW_FILTER_ON TRANS_ORIG Fog_VMD END_SHADER_MODE");
  EXPECT_THAT(files.warnings, testing::IsEmpty());
}

TEST_F(Tachyon, medium_shader_mode_has_no_shadows) {
  const std::string ball = "SPHERE CENTER 0 0 5 RAD 1" + white;
  EXPECT_FALSE(files.load_statements(ball).instances.at(0).casts_no_shadow);
  EXPECT_TRUE(files.load_statements(ball + "SHADER_MODE Medium END_SHADER_MODE").instances.at(0).casts_no_shadow);
  EXPECT_THAT(files.warnings, testing::IsEmpty());
}

TEST_F(Tachyon, low_shader_modes_show_plain_colours) {
  const std::string mirror =
      "SPHERE CENTER 0 0 5 RAD 1 TEXTURE AMBIENT 0 DIFFUSE 1 SPECULAR 0.5 OPACITY 0.5 PHONG PLASTIC 1 PHONG_SIZE 9 COLOR 1 0 0 "
      "TEXFUNC 0\n";
  for (const std::string quality : {"LOW", "LOWEST"}) {
    const Scene scene = files.load_statements("SHADER_MODE " + quality + " END_SHADER_MODE\n" + mirror);
    const PhongSurface& surface = test::phong(scene.materials.at(0));
    EXPECT_EQ(surface.ambient, 1.0f);
    EXPECT_EQ(surface.opacity, 1.0f);
    EXPECT_EQ(surface.diffuse + surface.mirror + surface.highlight, 0.0f);
  }
  EXPECT_THAT(files.warnings, ElementsAre(HasSubstr("scene.dat:4: SHADER_MODE LOWEST")));
}

TEST_F(Tachyon, vmd_transparency_scales_by_opacity) {
  const Scene scene = files.load_statements(
      "SPHERE CENTER 0 0 5 RAD 1 TEXTURE AMBIENT 0.2 DIFFUSE 0.8 SPECULAR 0.4 OPACITY 0.5 PHONG PLASTIC 1 PHONG_SIZE 9 COLOR 1 "
      "0 0 "
      "TEXFUNC 0\nSHADER_MODE FULL TRANS_VMD END_SHADER_MODE");
  const PhongSurface& surface = test::phong(scene.materials.at(0));
  EXPECT_EQ(surface.ambient, 0.1f);
  EXPECT_EQ(surface.diffuse, 0.4f);
  EXPECT_EQ(surface.mirror, 0.2f);
  EXPECT_EQ(surface.highlight, 0.5f);
  EXPECT_EQ(surface.opacity, 0.5f);
}

TEST_F(Tachyon, ignored_effects_give_one_warning) {
  files.load_statements(
      "SHADER_MODE FULL AMBIENT_OCCLUSION AMBIENT_COLOR 1 1 1 RESCALE_DIRECT 0.5 SAMPLES 8 TRANS_RASTER3D TRANS_MAX_SURFACES 3 "
      "SHADOW_FILTER_OFF END_SHADER_MODE\n"
      "FOG EXP2 START 0 END 10 DENSITY 0.4 COLOR 0 0 0\nSKY_LIGHT NUMSAMPLES 4 COLOR 1 1 1\n"
      "SPHERE CENTER 0 0 5 RAD 1 TEXTURE AMBIENT 0 DIFFUSE 1 SPECULAR 0 OPACITY 1 TRANSMODE R3D OUTLINE 4 OUTLINE_WIDTH 0.3 "
      "COLOR 1 1 1 TEXFUNC 0");
  EXPECT_THAT(files.warnings,
              ElementsAre("scene.dat:4: the effects 'AMBIENT_OCCLUSION', 'TRANS_RASTER3D', 'TRANS_MAX_SURFACES', "
                          "'SHADOW_FILTER_OFF', 'FOG', 'SKY_LIGHT', 'TRANSMODE R3D' and 'OUTLINE' are left out."));
}

TEST_F(Tachyon, orthographic_camera_sets_plane_height) {
  for (const std::string projection : {"PROJECTION ORTHOGRAPHIC ", "projection Orthographic ", "ORTHOGRAPHIC "}) {
    files.warnings.clear();
    const Scene scene = files.load_statements(camera("CENTER 0 0 0 VIEWDIR 0 0 1 UPDIR 0 1 0", projection + "ZOOM 0.25") +
                                              "SPHERE CENTER 0 0 5 RAD 1" + white);
    EXPECT_EQ(scene.cameras.at(0).orthographic_height, 4.0f) << "1 / ZOOM";
    EXPECT_THAT(files.warnings, ElementsAre(HasSubstr("ORTHOGRAPHIC sets the height of the display's plane")));
  }
  EXPECT_EQ(files.load_statements(camera("CENTER 0 0 0 VIEWDIR 0 0 1 UPDIR 0 1 0", "PERSPECTIVE ZOOM 1"))
                .cameras.at(0)
                .orthographic_height,
            0.0f);
}

TEST_F(Tachyon, tiny_orthographic_view_is_a_warning) {
  files.load_statements(camera("CENTER 200 -200 0 VIEWDIR 0 0 1 UPDIR 0 -1 0", "PROJECTION ORTHOGRAPHIC ZOOM 3") +
                        "SPHERE CENTER 200 -200 500 RAD 60" + white);
  EXPECT_THAT(files.warnings.back(),
              HasSubstr("ZOOM shows 0.333 units of a scene that is 208 units large, as Tachyon does; `zoom` 0.001 shows all"));
}

TEST_F(Tachyon, depth_of_field_is_ignored) {
  const Scene scene = files.load_statements(
      camera("CENTER 0 0 0 VIEWDIR 0 0 1 UPDIR 0 1 0", "PROJECTION Perspective_DoF FOCALDIST 3 APERTURE 64 ZOOM 1"));
  EXPECT_EQ(scene.cameras.size(), 1u);
  EXPECT_THAT(files.warnings, ElementsAre(HasSubstr("the depth of field of PERSPECTIVE_DOF is left out")));
}

/// The gradient reaches from the height -1 to 3, and the camera is at 1. Therefore, the gradient ends at the lower and
/// upper edge of the picture, which the assumed viewer sees 22.5 degrees from the axis.
TEST_F(Tachyon, orthographic_gradient_becomes_directions) {
  const Scene scene = files.load_statements(
      camera("CENTER 0 1 0 VIEWDIR 0 0 1 UPDIR 0 1 0", "PROJECTION ORTHOGRAPHIC ZOOM 0.25") +
      "BACKGROUND_GRADIENT SKY_ORTHO_PLANE UPDIR 0 1 0 TOPVAL 3 BOTTOMVAL -1 TOPCOLOR 1 0 0 BOTTOMCOLOR 0 0 1\n");
  EXPECT_NEAR(scene.background.zenith_at, std::sin(radians(22.5f)), 1e-5f);
  EXPECT_NEAR(scene.background.horizon_at, -std::sin(radians(22.5f)), 1e-5f);
}

TEST_F(Tachyon, light_is_a_visible_sphere) {
  const Scene scene = files.load_statements("LIGHT CENTER 1 2 3 RAD 0.25 COLOR 0.1 0.2 0.3");
  ASSERT_EQ(scene.lights.size(), 1u);
  const Light& light = scene.lights[0];
  EXPECT_EQ(light.kind, LightKind::kPoint);
  EXPECT_EQ(xyz(evaluate(scene, 0.0).of(light.node).translation), (std::array{1.0f, 2.0f, -3.0f}));
  EXPECT_EQ(light.visible_radius, 0.25f);
  EXPECT_EQ(xyz(light.color), (std::array{0.1f, 0.2f, 0.3f}));
  EXPECT_FALSE(light.inverse_square);
}

TEST_F(Tachyon, attenuation_is_constant_linear_quadratic) {
  const Scene scene =
      files.load_statements("LIGHT CENTER 1 2 3 RAD 0.25 ATTENUATION CONSTANT 1 LINEAR 0.2 QUADRATIC 0.05 COLOR 0 1 1");
  EXPECT_EQ(xyz(scene.lights[0].attenuation), (std::array{1.0f, 0.2f, 0.05f}));
  EXPECT_EQ(xyz(scene.lights[0].color), (std::array{0.0f, 1.0f, 1.0f}));
}

TEST_F(Tachyon, light_without_attenuation_does_not_fade) {
  const Scene scene = files.load_statements("LIGHT CENTER 1 2 3 RAD 0.25 COLOR 0 1 1");
  EXPECT_EQ(xyz(scene.lights[0].attenuation), (std::array{1.0f, 0.0f, 0.0f}));
}

/// The top colour is reached where dot(direction, UPDIR) = TOPVAL = 1.5. As |UPDIR| = 2, the component along UPDIR is
/// 0.75 there.
TEST_F(Tachyon, gradient_overrides_background) {
  const Scene scene = files.load_statements(
      "BACKGROUND_GRADIENT SKY_SPHERE UPDIR 0 0 2 TOPVAL 1.5 BOTTOMVAL -1 TOPCOLOR 0 0 1 BOTTOMCOLOR 1 0 0 BACKGROUND 1 1 1");
  EXPECT_EQ(xyz(scene.background.up), (std::array{0.0f, 0.0f, -1.0f}));
  EXPECT_EQ(scene.background.zenith_at, 0.75f);
  EXPECT_EQ(scene.background.horizon_at, -0.5f);
  EXPECT_EQ(xyz(scene.background.zenith), (std::array{0.0f, 0.0f, 1.0f}));
  EXPECT_EQ(xyz(scene.background.horizon), (std::array{1.0f, 0.0f, 0.0f}));
}

TEST_F(Tachyon, spotlight_shines_along_its_mirrored_direction) {
  const Scene scene =
      files.load_statements("SPOTLIGHT CENTER 1 2 3 RAD 0.5 DIRECTION 0 3 4 FALLOFF_START 20 FALLOFF_END 45 COLOR 1 0 0");
  const Light& light = scene.lights[0];
  EXPECT_EQ(light.kind, LightKind::kSpot);
  const Vec3f direction = transform_vector(evaluate(scene, 0.0).of(light.node), {0, 0, -1});
  EXPECT_LT(glm::length(direction - Vec3f(0.0f, 0.6f, -0.8f)), 1e-6f);  // rounding of a rotation
  EXPECT_NEAR(degrees(light.inner_cone), 20.0f, 1e-5f);
  EXPECT_NEAR(degrees(light.outer_cone), 45.0f, 1e-5f);
  EXPECT_EQ(light.visible_radius, 0.5f);
}

TEST_F(Tachyon, spotlight_of_180_degrees_is_valid) {
  EXPECT_NO_THROW(
      files.load_statements("SPOTLIGHT CENTER 1 2 3 RAD 0.5 DIRECTION 0 3 4 FALLOFF_START 180 FALLOFF_END 180 COLOR 1 0 0"));
}

TEST_F(Tachyon, directional_light_in_any_direction_keeps_it) {
  for (const Vec3f d : {Vec3f(0, 0, 1), Vec3f(0, 0, -1), Vec3f(0, 1, 0), Vec3f(0, -1, 0), Vec3f(1, 0, 0), Vec3f(2, -3, 6)}) {
    const Scene scene = files.load_statements("DIRECTIONAL_LIGHT DIRECTION " + std::to_string(d.x) + " " + std::to_string(d.y) +
                                              " " + std::to_string(d.z) + " COLOR 1 1 1");
    EXPECT_EQ(scene.lights[0].kind, LightKind::kDirectional);
    const Vec3f direction = transform_vector(evaluate(scene, 0.0).of(scene.lights[0].node), {0, 0, -1});
    const Vec3f expected = glm::normalize(Vec3f(d.x, d.y, -d.z));
    EXPECT_LT(glm::length(direction - expected), 1e-6f) << d.x << " " << d.y << " " << d.z;  // rounding of a rotation
  }
}

TEST_F(Tachyon, path_of_two_lines_is_three_frames) {
  files.write("scene.cam", "0 0 1  0 1 0  1 2 3\n3 0 0  0 0 2  4 5 6\n");
  files.camera_path = files.path("scene.cam");
  const Scene scene = files.load_statements("");
  EXPECT_EQ(scene.timeline.frame_count, 3);
  EXPECT_EQ(scene.timeline.frames_per_second, 25.0);
  ASSERT_EQ(scene.timeline.animations.size(), 1u);
  EXPECT_EQ(scene.timeline.animations[0].node, scene.cameras[0].node);

  EXPECT_EQ(xyz(frame_of(scene, scene.timeline.time(0)).origin), (std::array{1.0f, 2.0f, -3.0f}));
  for (const int frame : {1, 2}) {
    const CameraFrame last = frame_of(scene, scene.timeline.time(frame));
    EXPECT_EQ(xyz(last.origin), (std::array{4.0f, 5.0f, -6.0f}));
    EXPECT_EQ(xyz(last.forward), (std::array{1.0f, 0.0f, 0.0f}));
    EXPECT_EQ(xyz(last.up), (std::array{0.0f, 0.0f, -1.0f}));
  }
}

TEST_F(Tachyon, path_holds_poses_between_frames) {
  std::string lines;
  for (int i = 0; i < 100; ++i) lines += "0 0 1 0 1 0 " + std::to_string(i) + " 0 0\n";
  files.write("scene.cam", lines);
  files.camera_path = files.path("scene.cam");
  files.write("scene.dat", TachyonFiles::kPrelude + "END_SCENE");
  for (const double rate : {24.0, 25.0, 29.97, 30.0, 59.94}) {
    const Scene scene = files.load(rate);
    for (int frame = 0; frame < 100; ++frame)
      EXPECT_EQ(frame_of(scene, scene.timeline.time(frame)).origin.x, static_cast<float>(frame)) << rate;
  }
}

TEST_F(Tachyon, path_keeps_zoom) {
  files.write("scene.cam", "0 0 1 0 1 0 1 2 3");
  files.camera_path = files.path("scene.cam");
  const Scene scene = files.load_statements(camera("CENTER 9 9 9 VIEWDIR 1 0 0 UPDIR 0 1 0", "ZOOM 2"));
  EXPECT_EQ(scene.timeline.frame_count, 2);
  EXPECT_NEAR(std::tan(scene.cameras[0].vertical_fov / 2), 0.25f, 1e-6f);
}

struct BadPath {
  const char* text;
  const char* message;
};
void PrintTo(const BadPath& bad, std::ostream* out) { *out << bad.message; }

class TachyonBadPath : public testing::TestWithParam<BadPath> {};

TEST_P(TachyonBadPath, text_is_an_error_with_its_line) {
  TachyonFiles files;
  files.write("scene.cam", GetParam().text);
  files.camera_path = files.path("scene.cam");
  EXPECT_THAT(files.error_of(TachyonFiles::kPrelude + "END_SCENE"), testing::StartsWith(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    All, TachyonBadPath,
    testing::Values(BadPath{"", "scene.cam:1: the file ends, expected a view direction"},
                    BadPath{"\n\n", "scene.cam:3: the file ends, expected a view direction"},
                    BadPath{"0 0 1 0 1 0 0 0", "scene.cam:1: the file ends, expected a camera's centre"},
                    BadPath{"0 0 1 0 1 0 0 0 0\n1", "scene.cam:2: the file ends, expected a view direction"},
                    BadPath{"0 0 1 0 1 0 0 0 nan", "scene.cam:1: expected a number for"},
                    BadPath{"0 0 1 0 1 0 0 0 0\n0 0 0 0 1 0 0 0 0", "scene.cam:2: the camera's view and up"},
                    BadPath{"0 0 1 0 0 2 0 0 0", "scene.cam:1: the camera's view and up"}));

TEST_F(Tachyon, missing_path_is_an_error) {
  files.camera_path = files.path("no.cam");
  EXPECT_EQ(files.error_of(TachyonFiles::kPrelude + "END_SCENE"), "no.cam: does not exist");
}

}  // namespace
}  // namespace lippmann
