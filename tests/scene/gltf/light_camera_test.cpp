#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "lippmann/scene/timeline.hpp"
#include "scene/gltf/gltf_builder.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using test::GltfBuilder;
using test::Json;
using test::parse;
using testing::Contains;
using testing::HasSubstr;

GltfBuilder lit_by(const Json& light) {
  GltfBuilder b;
  b.root["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({light});
  b.add_node({{"children", {1}}});
  b.add_node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  return b;
}

Light light_of(const Json& light) {
  const Scene scene = parse(lit_by(light));
  validate(scene, "a.glb");
  return scene.lights.at(0);
}

TEST(GltfLight, point_light_uses_candela_and_falls_off) {
  const Light light =
      light_of({{"type", "point"}, {"name", "lamp"}, {"color", {1, 0.5, 0.25}}, {"intensity", 40}, {"range", 7}});
  EXPECT_EQ(light.name, "lamp");
  EXPECT_EQ(light.kind, LightKind::kPoint);
  EXPECT_EQ(light.color, Vec3f(40, 20, 10));
  EXPECT_TRUE(light.inverse_square);
  EXPECT_EQ(light.range, 7.0f);
  EXPECT_EQ(light.node, 1);
}

TEST(GltfLight, defaults_are_white_and_unbounded) {
  const Light light = light_of({{"type", "point"}});
  EXPECT_EQ(light.color, Vec3f(1.0f));
  EXPECT_EQ(light.range, kInfinity);
}

TEST(GltfLight, directional_light_does_not_fall_off) {
  const Light light = light_of({{"type", "directional"}, {"intensity", 3}});
  EXPECT_EQ(light.kind, LightKind::kDirectional);
  EXPECT_FALSE(light.inverse_square);
  EXPECT_EQ(light.color, Vec3f(3.0f));
}

TEST(GltfLight, spot_light_has_cones) {
  const Light light = light_of({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.2}}}});
  EXPECT_EQ(light.kind, LightKind::kSpot);
  EXPECT_TRUE(light.inverse_square);
  EXPECT_EQ(light.inner_cone, 0.1f);
  EXPECT_EQ(light.outer_cone, 0.2f);
}

TEST(GltfLight, spot_light_without_angles_reaches_45_degrees) {
  const Light light = light_of({{"type", "spot"}, {"spot", Json::object()}});
  EXPECT_EQ(light.inner_cone, 0.0f);
  EXPECT_FLOAT_EQ(light.outer_cone, kPi / 4);
}

TEST(GltfLight, missing_spot_is_an_error) {
  EXPECT_THAT(error_message([] { light_of({{"type", "spot"}}); }), HasSubstr("lights[0].spot: is missing"));
}

TEST(GltfLight, inner_cone_beyond_outer_is_an_error) {
  EXPECT_THAT(error_message([] {
                light_of({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.9}}}});
              }),
              HasSubstr("lights[0].spot: the inner cone is wider than the outer one"));
}

TEST(GltfLight, sizes_are_read_from_extras) {
  const Light point = light_of({{"type", "point"}, {"extras", {{"radius", 0.25}, {"angle", 1}}}});
  EXPECT_EQ(point.radius, 0.25f);
  EXPECT_EQ(point.angular_diameter, 0.0f) << "which suns have";
  const Light sun = light_of({{"type", "directional"}, {"extras", {{"radius", 0.25}, {"angle", 0.5}}}});
  EXPECT_EQ(sun.radius, 0.0f);
  EXPECT_EQ(sun.angular_diameter, 0.5f);
  EXPECT_EQ(light_of({{"type", "point"}}).radius, 0.0f);
  EXPECT_FLOAT_EQ(light_of({{"type", "directional"}, {"extras", {{"angle", 3.14159265359}}}}).angular_diameter, kPi);
}

// The outer half angle of 60 degrees has the cosine 0.5. A blend of 0.3 covers the cosines up to 0.5 + 0.3 * (1 - 0.5)
// = 0.65.
TEST(GltfLight, blend_replaces_the_inner_cone) {
  const Json cone{{"innerConeAngle", 0.2}, {"outerConeAngle", kPi / 3}};
  const Light soft = light_of({{"type", "spot"}, {"spot", cone}, {"extras", {{"radius", 2}, {"blend", 0.3}}}});
  EXPECT_EQ(soft.radius, 2.0f);
  EXPECT_TRUE(soft.smooth_edge);
  EXPECT_NEAR(std::cos(soft.inner_cone), 0.65f, 1e-6f);
  const Light sharp = light_of({{"type", "spot"}, {"spot", cone}, {"extras", {{"blend", 0}}}});
  EXPECT_FLOAT_EQ(sharp.inner_cone, sharp.outer_cone);
  EXPECT_FALSE(light_of({{"type", "spot"}, {"spot", cone}}).smooth_edge);
}

TEST(GltfLight, foreign_extras_are_ignored) {
  EXPECT_EQ(light_of({{"type", "point"}, {"extras", "a lamp"}}).radius, 0.0f);
  EXPECT_EQ(light_of({{"type", "point"}, {"extras", {{"radius", "large"}, {"shadow", true}}}}).radius, 0.0f);
  EXPECT_THAT(error_message([] {
                light_of({{"type", "point"}, {"extras", {{"radius", -1}}}});
              }),
              HasSubstr("lights[0].extras.radius"));
  EXPECT_THAT(error_message([] {
                light_of({{"type", "directional"}, {"extras", {{"angle", 7}}}});
              }),
              HasSubstr("lights[0].extras.angle"));
}

TEST(GltfLight, unknown_type_is_an_error) {
  EXPECT_THAT(error_message([] {
                light_of({{"type", "area"}});
              }),
              HasSubstr("extensions.KHR_lights_punctual.lights[0].type: is 'area'; accepted: directional, point, spot"));
}

// A point lamp of 100 W emits 100 / (4 pi) = 7.9577 W/sr. Blender's exporter writes 7.9577 * 683 lm/W = 5435.1 cd.
TEST(GltfLight, of_blenders_exporter_shines_as_in_blender) {
  GltfBuilder b = lit_by({{"type", "point"}, {"intensity", 5435.1415}});
  b.root["asset"]["generator"] = "Khronos glTF Blender I/O v3.4.50";
  EXPECT_NEAR(parse(b).lights.at(0).color.x, 7.9577f, 1e-3f);
}

float scale_by(const std::string& generator, const std::string& type) {
  GltfBuilder b = lit_by({{"type", type}, {"intensity", 100}, {"spot", Json::object()}});
  b.root["asset"]["generator"] = generator;
  return parse(b).lights.at(0).color.x / 100.0f;
}

// Old exporters store watts, so the factor is 1 / (4 pi) = 0.079577. New exporters store candela, so the factor is 1 /
// 683 = 0.001464.
TEST(GltfLight, old_blender_exporters_use_watts) {
  const std::string name = "Khronos glTF Blender I/O v";
  EXPECT_NEAR(scale_by(name + "3.4.39", "point"), 0.001464f, 1e-6f);
  EXPECT_NEAR(scale_by(name + "3.10.2", "point"), 0.001464f, 1e-6f);
  EXPECT_NEAR(scale_by(name + "3.4.38", "point"), 0.079577f, 1e-5f);
  EXPECT_NEAR(scale_by(name + "1.4.40", "spot"), 0.079577f, 1e-5f);
  EXPECT_EQ(scale_by(name + "1.4.40", "directional"), 1.0f);
  EXPECT_NEAR(scale_by(name + "4.2.70", "directional"), 0.001464f, 1e-6f);
  EXPECT_NEAR(scale_by("Khronos Blender glTF 2.0 I/O", "point"), 0.079577f, 1e-5f);
  EXPECT_EQ(scale_by("another exporter v1.0", "point"), 1.0f);
}

Light spot_of(const std::string& generator, float inner, const Json& extras = Json::object()) {
  GltfBuilder b =
      lit_by({{"type", "spot"}, {"spot", {{"innerConeAngle", inner}, {"outerConeAngle", kPi / 3}}}, {"extras", extras}});
  b.root["asset"]["generator"] = generator;
  return parse(b).lights.at(0);
}

// Blender's exporter writes inner = outer (1 - blend), so 0.7 means a blend of 0.3, which covers the cosines from 0.5
// to 0.5 + 0.3 * 0.5 = 0.65.
TEST(GltfLight, blender_spots_get_their_blend) {
  const std::string blender = "Khronos glTF Blender I/O v3.4.50";
  const Light soft = spot_of(blender, 0.7f * kPi / 3);
  EXPECT_TRUE(soft.smooth_edge);
  EXPECT_NEAR(std::cos(soft.inner_cone), 0.65f, 1e-6f);
  EXPECT_NEAR(spot_of(blender, 0.0f).inner_cone, 0.0f, 1e-3f) << "a blend of 1";
  EXPECT_FLOAT_EQ(spot_of(blender, kPi / 3).inner_cone, kPi / 3) << "a blend of 0";
  EXPECT_NEAR(std::cos(spot_of(blender, 0.0f, {{"blend", 0.3}}).inner_cone), 0.65f, 1e-6f) << "what extras say comes first";
  EXPECT_TRUE(spot_of("Khronos Blender glTF 2.0 I/O", 0.5f).smooth_edge);
}

TEST(GltfLight, spots_of_other_exporters_keep_their_cones) {
  const Light light = spot_of("another exporter v1.0", 0.5f);
  EXPECT_FALSE(light.smooth_edge);
  EXPECT_EQ(light.inner_cone, 0.5f);
}

TEST(GltfLight, scene_with_light_has_black_background) {
  GltfBuilder b = lit_by({{"type", "point"}});
  b.add_node({{"mesh", b.add_triangle()}});
  const Scene scene = parse(b);
  EXPECT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.background.horizon, Vec3f(0.0f));
}

TEST(GltfLight, scene_of_unlit_materials_needs_none) {
  GltfBuilder b;
  b.add("materials", {{"extensions", {{"KHR_materials_unlit", Json::object()}}}});
  b.add_node({{"mesh", b.add_triangle({{"material", 0}})}});
  std::vector<std::string> warnings;
  EXPECT_TRUE(parse(b, &warnings).lights.empty());
  EXPECT_TRUE(warnings.empty());
}

TEST(GltfCamera, perspective_cameras_follow_node_order) {
  GltfBuilder b;
  b.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}});
  b.add("cameras",
        {{"type", "perspective"}, {"name", "wide"}, {"perspective", {{"yfov", 0.75}, {"znear", 1}, {"aspectRatio", 1.5}}}});
  b.add_node({{"camera", 1}});
  b.add_node({{"camera", 0}, {"name", "left"}});
  const Scene scene = parse(b);
  ASSERT_EQ(scene.cameras.size(), 2u);
  EXPECT_EQ(scene.cameras[0].name, "wide");
  EXPECT_EQ(scene.cameras[0].vertical_fov, 0.75f);
  EXPECT_EQ(scene.cameras[0].aspect, 1.5f);
  EXPECT_EQ(scene.cameras[1].name, "left");
  EXPECT_EQ(scene.cameras[1].vertical_fov, 0.5f);
  EXPECT_EQ(scene.cameras[1].aspect, 0.0f);
  EXPECT_EQ(scene.cameras[1].node, 1);
}

TEST(GltfCamera, description_of_another_type_is_an_error) {
  GltfBuilder b;
  b.add("cameras", {{"type", "perspective"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0}, {"zfar", 1}}}});
  b.add_node({{"camera", 0}});
  EXPECT_THAT(error_message([&] { parse(b); }), HasSubstr("cameras[0].perspective: is missing"));
}

TEST(GltfCamera, near_plane_and_shift_are_read) {
  GltfBuilder b;
  b.add("cameras", {{"type", "perspective"},
                    {"perspective", {{"yfov", 0.5}, {"znear", 0.25}}},
                    {"extras", {{"shift_x", 0.5}, {"shift_y", "strange"}}}});
  b.add("cameras", {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", -1}, {"zfar", 1}}}});
  b.add_node({{"camera", 0}});
  b.add_node({{"camera", 1}});
  const Scene scene = parse(b);
  EXPECT_EQ(scene.cameras.at(0).near_distance, 0.25f);
  EXPECT_EQ(scene.cameras[0].shift, Vec2f(0.5f, 0.0f));
  EXPECT_EQ(scene.cameras.at(1).near_distance, 0.0f) << "behind the camera";
}

TEST(GltfCamera, scene_without_one_has_none) {
  GltfBuilder b;
  b.add_node({{"mesh", b.add_triangle()}});
  EXPECT_TRUE(parse(b).cameras.empty());
}

TEST(GltfCamera, orthographic_has_height_and_angle) {
  GltfBuilder b;
  b.add_node({{"mesh", b.add_triangle()}, {"translation", {-0.5, -0.5, -8}}});
  b.add("cameras", {{"type", "orthographic"}, {"orthographic", {{"xmag", 4}, {"ymag", 2}, {"znear", 0}, {"zfar", 100}}}});
  b.add_node({{"camera", 0}, {"translation", {0, 0, 2}}});
  std::vector<std::string> warnings;
  const Scene scene = parse(b, &warnings);
  EXPECT_FLOAT_EQ(std::tan(0.5f * scene.cameras.at(0).vertical_fov), 2.0f / 10.0f);
  EXPECT_EQ(scene.cameras[0].aspect, 2.0f);
  EXPECT_EQ(scene.cameras[0].orthographic_height, 4.0f);
  EXPECT_TRUE(warnings.empty());
}

TEST(GltfCamera, orthographic_works_without_visible_objects) {
  GltfBuilder b;
  b.add("cameras", {{"type", "orthographic"}, {"orthographic", {{"xmag", 0}, {"ymag", 0}, {"znear", 0}, {"zfar", 0}}}});
  b.add_node({{"camera", 0}});
  EXPECT_NO_THROW(validate(parse(b), "a.glb"));
}

// The triangle's bounds are 1 x 1, so their diagonal is sqrt(2).
TEST(GltfCamera, zero_orthographic_size_shows_all_with_warning) {
  GltfBuilder b;
  b.add_node({{"mesh", b.add_triangle()}});
  b.add("cameras", {{"type", "orthographic"}, {"orthographic", {{"xmag", 0}, {"ymag", 0}, {"znear", 0}, {"zfar", 10}}}});
  b.add_node({{"camera", 0}, {"translation", {0, 0, 4}}});
  std::vector<std::string> warnings;
  const Scene scene = parse(b, &warnings);
  EXPECT_FLOAT_EQ(scene.cameras.at(0).orthographic_height, std::sqrt(2.0f));
  EXPECT_EQ(scene.cameras[0].aspect, 0.0f);
  EXPECT_THAT(
      warnings,
      Contains(
          "a.glb: orthographic cameras with an xmag or ymag of 0 are enlarged to show the whole scene (first at cameras[0])"));
}

}  // namespace
}  // namespace lippmann
