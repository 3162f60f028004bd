#include <gtest/gtest.h>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using test::Picture;
using test::single_view;
using test::SmallScene;
using test::square;
using test::trace;

Texture row_of(std::initializer_list<int> greys, int alpha = 255) {
  Texture t;
  t.width = static_cast<int>(greys.size()), t.height = 1;
  t.srgb = false;
  for (const int grey : greys)
    for (int c = 0; c < 4; ++c) t.rgba.push_back(static_cast<std::uint8_t>(c == 3 ? alpha : grey));
  return t;
}

MetallicRoughness unlit() {
  MetallicRoughness s;
  s.unlit = true;
  return s;
}

/// Radiance in the middle of the left and of the right half of a square that fills the picture. The background is 1.
struct Halves {
  float left, right;
};
Halves render(const Mesh& mesh, const MetallicRoughness& surface, const Texture& texture) {
  SmallScene s;
  s.scene.max_depth = 2;
  s.scene.background.horizon = s.scene.background.zenith = Vec3f(1.0f);
  s.scene.textures.push_back(texture);
  s.scene.materials.push_back({"", surface});
  s.add(mesh, 0);
  const Picture p = trace(s.scene, single_view(32));
  return {p.at(8, 16).x, p.at(24, 16).x};
}

TEST(MeshMaterial, maps_follow_their_transform) {
  MetallicRoughness s = unlit();
  s.base_color_map.texture = 0;
  const Halves as_it_is = render(square(2, 0), s, row_of({0, 0, 255, 255}));
  EXPECT_EQ(as_it_is.left, 0.0f);
  EXPECT_EQ(as_it_is.right, 1.0f);
  s.base_color_map.offset = {0.5f, 0.0f};
  const Halves moved = render(square(2, 0), s, row_of({0, 0, 255, 255}));
  EXPECT_EQ(moved.left, 1.0f);
  EXPECT_EQ(moved.right, 0.0f);
  s.base_color_map.offset = {1.0f, 0.0f};
  s.base_color_map.matrix[0].x = -1.0f;
  const Halves mirrored = render(square(2, 0), s, row_of({0, 0, 255, 255}));
  EXPECT_EQ(mirrored.left, 1.0f);
  EXPECT_EQ(mirrored.right, 0.0f);
}

TEST(MeshMaterial, footprint_grows_with_the_scale_of_the_transform) {
  MetallicRoughness s = unlit();
  s.base_color_map.texture = 0;
  s.base_color_map.matrix[0].x = 64.0f;  // 64 periods on 32 pixels, so only their mean is visible
  const Halves blurred = render(square(2, 0), s, row_of({0, 0, 255, 255}));
  EXPECT_NEAR(blurred.left, 0.5f, 1e-3f);  // rounding of 16-bit codes in the coarsest level
  EXPECT_NEAR(blurred.right, 0.5f, 1e-3f);
}

TEST(MeshMaterial, maps_use_their_coordinate_set) {
  Mesh mesh = square(2, 0);
  for (const Vec2f uv : mesh.uvs) mesh.uvs_1.push_back({1.0f - uv.x, uv.y});
  MetallicRoughness s = unlit();
  s.base_color = Vec4f(0, 0, 0, 1);
  s.emissive = Vec3f(1.0f);
  s.emissive_map.texture = 0;
  const Halves first = render(mesh, s, row_of({0, 0, 255, 255}));
  EXPECT_EQ(first.left, 0.0f);
  EXPECT_EQ(first.right, 1.0f);
  s.emissive_map.uv_set = 1;
  const Halves second = render(mesh, s, row_of({0, 0, 255, 255}));
  EXPECT_EQ(second.left, 1.0f);
  EXPECT_EQ(second.right, 0.0f);
}

TEST(MeshMaterial, missing_coordinate_sets_use_the_factor) {
  MetallicRoughness s = unlit();
  s.base_color = Vec4f(0.5f, 0, 0, 1);
  s.base_color_map.texture = 0;
  s.base_color_map.uv_set = 1;
  EXPECT_EQ(render(square(2, 0), s, row_of({0})).left, 0.5f);
}

TEST(MeshMaterial, blend_multiplies_all_alphas) {
  Mesh mesh = square(2, 0);
  mesh.alphas.assign(4, 0.5f);
  MetallicRoughness s = unlit();
  s.base_color = Vec4f(0, 0, 0, 0.5f);
  s.base_color_map.texture = 0;
  s.blend = true;
  // Black with alpha 0.5 (material) x 0.5 (vertices) x 128/255 (texture), in front of white.
  EXPECT_NEAR(render(mesh, s, row_of({255}, 128)).left, 1.0f - 0.25f * 128.0f / 255.0f, 1e-5f);
}

TEST(MeshMaterial, mask_compares_the_product_of_alphas) {
  Mesh mesh = square(2, 0);
  mesh.alphas = {0.4f, 0.8f, 0.8f, 0.4f};  // from left to right: 0.5 at 1/4 and 0.7 at 3/4 of the width
  MetallicRoughness s = unlit();
  s.base_color = Vec4f(0, 0, 0, 0.5f);
  s.alpha_cutoff = 0.3f;
  const Halves cut = render(mesh, s, row_of({255}));
  EXPECT_EQ(cut.left, 1.0f);
  EXPECT_EQ(cut.right, 0.0f);
}

TEST(MeshMaterial, opaque_surfaces_ignore_alphas) {
  Mesh mesh = square(2, 0);
  mesh.alphas.assign(4, 0.0f);
  MetallicRoughness s = unlit();
  s.base_color = Vec4f(0, 0, 0, 0);
  EXPECT_EQ(render(mesh, s, row_of({255})).left, 0.0f);
}

TEST(MeshMaterial, vertex_colours_multiply_base_colour_and_texture) {
  Mesh mesh = square(2, 0);
  mesh.colors.assign(4, Vec3f(0.5f));
  MetallicRoughness s = unlit();
  s.base_color = Vec4f(0.5f, 0, 0, 1);
  s.base_color_map.texture = 0;
  EXPECT_NEAR(render(mesh, s, row_of({51})).left, 0.5f * 0.5f * 0.2f, 1e-5f);
}

/// The metal below a lamp is brushed along x and then rotated by `turned` radians.
Picture brushed(float strength, float turned, const Texture* map = nullptr) {
  SmallScene s;
  MetallicRoughness metal;
  metal.roughness = 0.5f;
  Anisotropy& brush = metal.extensions.emplace().anisotropy;
  brush.strength = strength, brush.rotation = turned;
  if (map) s.scene.textures.push_back(*map), brush.map.texture = 0;
  s.add(square(2, 0), s.material(metal));
  s.point_light({2, 1, 3}, Vec3f(20.0f));
  return test::trace_paths(s.scene, single_view(16), 1);
}

TEST(MeshMaterial, map_rotates_and_scales_anisotropy) {
  Texture map = row_of({0});
  map.rgba = {128, 255, 128, 255};  // a quarter turn (green), and half of the strength (blue)
  const Picture by_map = brushed(1.0f, 0.0f, &map), by_numbers = brushed(0.5f, 1.5707964f), along = brushed(0.5f, 0.0f);
  EXPECT_NEAR(by_map.at(8, 8).x / by_numbers.at(8, 8).x, 1.0f, 0.02f);
  EXPECT_NEAR(by_map.at(12, 3).x / by_numbers.at(12, 3).x, 1.0f, 0.02f);
  EXPECT_GT(std::abs(along.at(8, 8).x / by_numbers.at(8, 8).x - 1.0f), 0.1f);
}

Texture leaning(float degrees) {
  const float a = radians(degrees);
  Texture map = row_of({0});
  map.rgba = {static_cast<std::uint8_t>(std::lround(127.5f * (1.0f + std::sin(a)))), 128,
              static_cast<std::uint8_t>(std::lround(127.5f * (1.0f + std::cos(a)))), 255};
  return map;
}

/// `layered` adds a sheen too faint to be visible, so that LayeredBsdf is used.
MetallicRoughness coated(bool layered) {
  MetallicRoughness m;
  m.clearcoat = 1.0f;
  m.normal_map.texture = 0, m.clearcoat_normal_map.texture = 1;
  if (layered) m.extensions.emplace().sheen.color = Vec3f(1e-6f);
  return m;
}

/// Returns the radiance of the middle, seen perpendicularly. The normals of base and coat lean to the right by
/// `base_degrees` and `coat_degrees`, and the direction to the lamp by `lamp_degrees`.
float lit_from(MetallicRoughness m, float base_degrees, float coat_degrees, float lamp_degrees) {
  SmallScene s;
  s.scene.textures = {leaning(base_degrees), leaning(coat_degrees)};
  s.add(square(2, 0), s.material(m));
  const float a = radians(lamp_degrees);
  s.point_light(1000.0f * Vec3f(std::sin(a), 0.0f, std::cos(a)));
  return test::trace_paths(s.scene, single_view(33), 16).at(16, 16).x;
}

// Base and coat each reflect a lamp at twice the angle of their normal.
TEST(MeshMaterial, coat_and_base_use_separate_normal_maps) {
  for (const bool layered : {false, true}) {
    MetallicRoughness m = coated(layered);
    m.roughness = m.clearcoat_roughness = 0.3f;
    const float base = lit_from(m, 20, -15, 40), coat = lit_from(m, 20, -15, -30), beside = lit_from(m, 20, -15, 0);
    EXPECT_GT(base, 3.0f * beside) << layered;
    EXPECT_LT(lit_from(m, -20, -15, 40), 0.1f * base) << layered;
    m.base_color = Vec4f(0, 0, 0, 1);
    const float coat_alone = lit_from(m, 20, -15, -30);
    EXPECT_GT(coat_alone, 10.0f * lit_from(m, 20, 15, -30)) << layered;
    EXPECT_GT(coat, coat_alone) << layered;
    MetallicRoughness other = coated(!layered);
    other.roughness = other.clearcoat_roughness = 0.3f;
    EXPECT_NEAR(base, lit_from(other, 20, -15, 40), 1e-4f * base);
  }
}

// The lamp is below the horizon of the base's bent normal, but in front of the facet and of the coat's normal. A black
// base must not hide the lamp from the coat.
TEST(MeshMaterial, rough_coats_show_lamps_behind_the_base) {
  for (const bool layered : {false, true}) {
    MetallicRoughness m = coated(layered);
    m.metallic = 0.0f, m.specular = 0.0f, m.base_color = Vec4f(0, 0, 0, 1);
    m.clearcoat_roughness = 0.8f;
    const float above = lit_from(m, 0, 0, -60);
    EXPECT_GT(above, 1e-3f) << layered;
    EXPECT_NEAR(lit_from(m, 50, 0, -60), above, 0.01f * above) << layered;
  }
}

// The base is black, so only the coat reflects light. Bending the base's normal must not change the albedo by more than
// the noise of 1 %.
TEST(MeshMaterial, rough_coats_keep_their_albedo) {
  const auto in_white_furnace = [](const MetallicRoughness& m, float base_degrees) {
    SmallScene s;
    s.scene.max_depth = 2;
    test::surround(s, Vec3f(1.0f));
    s.scene.textures = {leaning(base_degrees), leaning(0)};
    s.add(square(2, 0), s.material(m));
    return test::mean(test::trace_paths(s.scene, single_view(16), 256).film);
  };
  for (const bool layered : {false, true}) {
    MetallicRoughness m = coated(layered);
    m.metallic = 0.0f, m.specular = 0.0f, m.base_color = Vec4f(0, 0, 0, 1);
    m.clearcoat_roughness = 0.9f;
    const double flat = in_white_furnace(m, 0.0f);
    EXPECT_GT(flat, 0.01) << layered;
    EXPECT_NEAR(in_white_furnace(m, 60.0f), flat, 0.01 * flat) << layered;
  }
}

}  // namespace
}  // namespace lippmann
