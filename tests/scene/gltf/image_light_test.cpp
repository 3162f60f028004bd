#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "lippmann/scene/load.hpp"
#include "scene/gltf/gltf_builder.hpp"
#include "support/encode_image.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::encode_png;
using test::error_message;
using test::GltfBuilder;
using test::Json;
using test::parse;
using testing::Contains;
using testing::HasSubstr;

using Rgba = std::array<unsigned char, 4>;

int add_picture(GltfBuilder& b, int width, int height, const std::vector<Rgba>& texels) {
  std::vector<unsigned char> codes;
  for (const Rgba& texel : texels) codes.insert(codes.end(), texel.begin(), texel.end());
  const int view = b.add_view(encode_png(width, height, 4, codes));
  return b.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
}

int add_plain(GltfBuilder& b, Rgba color) { return add_picture(b, 1, 1, {color}); }

GltfBuilder surrounded_by(GltfBuilder b, const Json& faces, const Json& more = Json::object()) {
  Json light = {{"specularImages", {faces}}, {"specularImageSize", 1}, {"irradianceCoefficients", Json::array()}};
  light.update(more);
  b.root["extensions"]["EXT_lights_image_based"]["lights"] = Json::array({light});
  b.root["extensionsRequired"] = {"EXT_lights_image_based"};
  b.add_node({{"mesh", b.add_triangle()}});
  b.add("scenes", {{"nodes", {0}}, {"extensions", {{"EXT_lights_image_based", {{"light", 0}}}}}});
  return b;
}

/// A cube map with uniform faces. The x faces are red, the y faces green, the z faces blue. The colour code is 255 on
/// the positive side of each axis, and 128 on the negative side.
GltfBuilder coloured_cube(const Json& more = Json::object()) {
  GltfBuilder b;
  Json faces;
  for (const Rgba color : {Rgba{255, 0, 0, 255}, Rgba{128, 0, 0, 255}, Rgba{0, 255, 0, 255}, Rgba{0, 128, 0, 255},
                           Rgba{0, 0, 255, 255}, Rgba{0, 0, 128, 255}})
    faces.push_back(add_plain(b, color));
  return surrounded_by(b, faces, more);
}

const EnvironmentMap& map_of(const Scene& scene) {
  validate(scene, "a.glb");
  return scene.background.map.value();
}

Vec3f seen(const EnvironmentMap& map, Vec3f direction) {
  const Vec3f d = glm::normalize(direction);
  const Image& p = map.radiance;
  const float across = 0.5f + std::atan2(d.z, d.x) / (2.0f * kPi), down = std::acos(d.y) / kPi;
  const float* c = p.pixel(std::min(static_cast<int>(across * static_cast<float>(p.width)), p.width - 1),
                           std::min(static_cast<int>(down * static_cast<float>(p.height)), p.height - 1));
  return {c[0], c[1], c[2]};
}

void expect_color(Vec3f actual, Vec3f expected) {
  EXPECT_LE(glm::length(actual - expected), 1e-5f * (1.0f + glm::length(expected)))
      << actual.x << " " << actual.y << " " << actual.z;
}

// linear value of the sRGB code 128: ((128 / 255 + 0.055) / 1.055)^2.4
constexpr float kHalf = 0.2158605f;

TEST(GltfImageLight, faces_lie_where_their_order_says) {
  const Scene scene = parse(coloured_cube());
  const EnvironmentMap& map = map_of(scene);
  EXPECT_EQ(map.strength, 1.0f);
  EXPECT_EQ(map.radiance.width, 2 * map.radiance.height);
  expect_color(seen(map, {1, 0.1f, 0.1f}), {1, 0, 0});
  expect_color(seen(map, {-1, 0.1f, 0.1f}), {kHalf, 0, 0});
  expect_color(seen(map, {0.1f, 1, 0.1f}), {0, 1, 0});
  expect_color(seen(map, {0.1f, -1, 0.1f}), {0, kHalf, 0});
  expect_color(seen(map, {0.1f, 0.1f, 1}), {0, 0, 1});
  expect_color(seen(map, {0.1f, 0.1f, -1}), {0, 0, kHalf});
}

// Only the upper left of each face's 2 x 2 texels is white. If a viewer in the cube looks along x, with y up, then z is
// to the right. If the viewer looks along y, with -z up, then -x is to the right.
TEST(GltfImageLight, faces_are_seen_from_inside) {
  GltfBuilder b;
  const Rgba white{255, 255, 255, 255}, black{0, 0, 0, 255};
  const Json faces(6, add_picture(b, 2, 2, {white, black, black, black}));
  const Scene scene = parse(surrounded_by(b, faces));
  const Vec3f upper_left[] = {{1, 0.8f, -0.8f}, {-1, 0.8f, 0.8f}, {0.8f, 1, -0.8f},
                              {0.8f, -1, 0.8f}, {0.8f, 0.8f, 1},  {-0.8f, 0.8f, -1}};
  for (const Vec3f& d : upper_left) {
    EXPECT_GT(seen(map_of(scene), d).x, 0.9f) << d.x << " " << d.y << " " << d.z;
    EXPECT_LT(seen(map_of(scene),
                   d * Vec3f(std::abs(d.x) == 1.0f ? 1 : -1, std::abs(d.y) == 1.0f ? 1 : -1, std::abs(d.z) == 1.0f ? 1 : -1))
                  .x,
              0.1f)
        << "the opposite corner of the face";
  }
}

// The alpha of 51 / 255 = 0.2 divides the colours: 1 / 0.2 = 5.
TEST(GltfImageLight, alpha_divides_colours) {
  GltfBuilder b;
  const int picture = add_plain(b, {255, 128, 0, 51});
  const Scene scene = parse(surrounded_by(b, Json(6, picture)));
  expect_color(seen(map_of(scene), {1, 0, 0}), {5.0f, 5.0f * kHalf, 0});
}

// The rotation by 90 degrees about y turns the cube's +x to -z.
TEST(GltfImageLight, is_turned_and_scaled) {
  const float half_root = std::sqrt(0.5f);
  const Scene scene = parse(coloured_cube({{"rotation", {0, half_root, 0, half_root}}, {"intensity", 3}}));
  EXPECT_EQ(map_of(scene).strength, 3.0f);
  expect_color(seen(map_of(scene), {0.1f, 0.1f, -1}), {1, 0, 0});
  expect_color(seen(map_of(scene), {1, 0.1f, 0.1f}), {0, 0, 1});
}

TEST(GltfImageLight, blurred_levels_are_not_looked_at) {
  GltfBuilder b = coloured_cube();
  b.root["extensions"]["EXT_lights_image_based"]["lights"][0]["specularImages"].push_back(Json(6, 5));
  expect_color(seen(map_of(parse(b)), {1, 0, 0}), {1, 0, 0});
}

TEST(GltfImageLight, that_no_scene_refers_to_surrounds_nothing) {
  GltfBuilder b = coloured_cube();
  b.root["scenes"][0].erase("extensions");
  EXPECT_FALSE(parse(b).background.map);
}

TEST(GltfImageLight, missing_image_is_a_warning) {
  GltfBuilder b = coloured_cube();
  b.root["images"][3] = {{"uri", "there_is_no_such_file.png"}};
  std::vector<std::string> warnings;
  EXPECT_FALSE(parse(b, &warnings).background.map);
  EXPECT_THAT(warnings,
              Contains(HasSubstr("environment lights whose images cannot be read are left out: 'there_is_no_such_file.png'")));
}

std::string message_of_light(const GltfBuilder& b) {
  return error_message([&] { parse(b); });
}

TEST(GltfImageLight, faces_that_make_no_cube_are_errors) {
  GltfBuilder b = coloured_cube();
  b.root["extensions"]["EXT_lights_image_based"]["lights"][0]["specularImages"][0][5] = add_picture(b, 2, 1, {Rgba{}, Rgba{}});
  EXPECT_EQ(message_of_light(b), "a.glb: images[6]: has 2 x 1 pixels; accepted: square faces of 1 to 16384 pixels");
  b.root["extensions"]["EXT_lights_image_based"]["lights"][0]["specularImages"][0][5] =
      add_picture(b, 2, 2, {Rgba{}, Rgba{}, Rgba{}, Rgba{}});
  EXPECT_EQ(message_of_light(b), "a.glb: images[7]: is 2 pixels wide in a cube map of 1 pixels");
}

TEST(GltfImageLight, bad_values_are_errors_that_name_them) {
  const auto one_level = [](const std::vector<int>& faces) { return Json::array({Json(faces)}); };
  struct Bad {
    const char* property;
    Json value;
    const char* message;
  };
  const Bad bad[] = {{"specularImages", Json::array(), "lights[0].specularImages: is empty"},
                     {"specularImages", one_level({0, 1, 2, 3, 4}), "specularImages[0]: has 5 entries; accepted: 6"},
                     {"specularImages", one_level({0, 1, 2, 3, 4, 6}),
                      "specularImages[0][5]: refers to images[6], but the number of images is 6"},
                     {"specularImages", Json::array({0}), "specularImages[0]: is not an array"},
                     {"intensity", -1, "intensity: is -1"},
                     {"rotation", {0, 0, 0, 0}, "lights[0].rotation: is not a unit quaternion"}};
  for (const Bad& one : bad) EXPECT_THAT(message_of_light(coloured_cube({{one.property, one.value}})), HasSubstr(one.message));
}

}  // namespace
}  // namespace lippmann
