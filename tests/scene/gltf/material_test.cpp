#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/gltf/gltf_builder.hpp"
#include "support/encode_image.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::encode_jpeg;
using test::encode_png;
using test::encode_webp;
using test::error_message;
using test::GltfBuilder;
using test::Json;
using test::parse;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<unsigned char> four_colours() {
  return encode_png(2, 2, 4, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 0});
}

Scene scene_of_material(const Json& material, std::vector<std::string>* warnings = nullptr) {
  GltfBuilder b;
  b.add("materials", material);
  b.add_node({{"mesh", b.add_triangle({{"material", 0}})}});
  Scene scene = parse(b, warnings);
  validate(scene, "a.glb");
  return scene;
}

MetallicRoughness surface_of(const Json& material, std::vector<std::string>* warnings = nullptr) {
  return std::get<MetallicRoughness>(scene_of_material(material, warnings).materials.at(0).surface);
}

GltfBuilder textured(const std::vector<unsigned char>& image, const Json& sampler = Json::object()) {
  GltfBuilder b;
  b.add("images", {{"bufferView", b.add_view(image)}, {"mimeType", "image/png"}, {"name", "colours"}});
  b.add("samplers", sampler);
  b.add("textures", {{"source", 0}, {"sampler", 0}});
  b.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  b.add_node({{"mesh", b.add_triangle({{"material", 0}})}});
  return b;
}

TEST(GltfMaterial, empty_material_has_the_defaults_of_gltf) {
  const MetallicRoughness s = surface_of(Json::object());
  EXPECT_EQ(s.base_color, Vec4f(1.0f));
  EXPECT_EQ(s.metallic, 1.0f);
  EXPECT_EQ(s.roughness, 1.0f);
  EXPECT_EQ(s.emissive, Vec3f(0.0f));
  EXPECT_EQ(s.ior, 1.5f);
  EXPECT_EQ(s.transmission, 0.0f);
  EXPECT_EQ(s.alpha_cutoff, 0.0f);
  EXPECT_FALSE(s.blend || s.double_sided || s.unlit);
}

TEST(GltfMaterial, factors_are_read) {
  const MetallicRoughness s = surface_of(
      {{"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}}, {"metallicFactor", 0.5}, {"roughnessFactor", 0.6}}},
       {"emissiveFactor", {0.7, 0.8, 0.9}},
       {"doubleSided", true}});
  EXPECT_EQ(s.base_color, Vec4f(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(s.metallic, 0.5f);
  EXPECT_EQ(s.roughness, 0.6f);
  EXPECT_EQ(s.emissive, Vec3f(0.7f, 0.8f, 0.9f));
  EXPECT_TRUE(s.double_sided);
}

TEST(GltfMaterial, emissive_strength_multiplies_the_factor) {
  const MetallicRoughness s = surface_of(
      {{"emissiveFactor", {1, 0.5, 0}}, {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 100}}}}}});
  EXPECT_EQ(s.emissive, Vec3f(100, 50, 0));
}

TEST(GltfMaterial, extensions_for_glass_are_read) {
  const MetallicRoughness s =
      surface_of({{"extensions",
                   {{"KHR_materials_ior", {{"ior", 1.33}}}, {"KHR_materials_transmission", {{"transmissionFactor", 0.75}}}}}});
  EXPECT_EQ(s.ior, 1.33f);
  EXPECT_EQ(s.transmission, 0.75f);
}

TEST(GltfMaterial, unlit_is_read) {
  EXPECT_TRUE(surface_of({{"extensions", {{"KHR_materials_unlit", Json::object()}}}}).unlit);
}

TEST(GltfMaterial, zero_ior_reflects_everything) {
  const float ior = surface_of({{"extensions", {{"KHR_materials_ior", {{"ior", 0}}}}}}).ior;
  const float reflectance = std::pow((ior - 1.0f) / (ior + 1.0f), 2.0f);
  EXPECT_GT(reflectance, 0.99f);  // the reader's ior of 1000 gives 0.996
}

TEST(GltfMaterial, ior_below_one_becomes_one_with_warning) {
  std::vector<std::string> warnings;
  const Json material{{"name", "ball"}, {"extensions", {{"KHR_materials_ior", {{"ior", 0.5}}}}}};
  EXPECT_EQ(surface_of(material, &warnings).ior, 1.0f);
  EXPECT_THAT(warnings, ElementsAre("a.glb: an ior between 0 and 1 is replaced by 1, without refraction or reflection (first "
                                    "at materials[0] 'ball')"));
}

TEST(GltfMaterial, mask_has_a_cutoff) {
  EXPECT_EQ(surface_of({{"alphaMode", "MASK"}}).alpha_cutoff, 0.5f);
  EXPECT_EQ(surface_of({{"alphaMode", "MASK"}, {"alphaCutoff", 0.25}}).alpha_cutoff, 0.25f);
  EXPECT_FALSE(surface_of({{"alphaMode", "MASK"}}).blend);
  EXPECT_EQ(surface_of({{"alphaMode", "BLEND"}, {"alphaCutoff", 0.25}}).alpha_cutoff, 0.0f);
  EXPECT_TRUE(surface_of({{"alphaMode", "BLEND"}}).blend);
}

TEST(GltfMaterial, primitives_without_one_share_the_default) {
  GltfBuilder b;
  b.add("materials", {{"name", "named"}});
  for (int i = 0; i < 2; ++i) b.add_node({{"mesh", b.add_triangle()}});
  const Scene scene = parse(b);
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.instances[0].material, 1);
  EXPECT_EQ(scene.instances[1].material, 1);
}

TEST(GltfMaterial, specular_and_clearcoat_are_read) {
  const MetallicRoughness s =
      surface_of({{"extensions",
                   {{"KHR_materials_specular", {{"specularFactor", 0.25}, {"specularColorFactor", {2, 0.5, 0}}}},
                    {"KHR_materials_clearcoat", {{"clearcoatFactor", 0.75}, {"clearcoatRoughnessFactor", 0.125}}}}}});
  EXPECT_EQ(s.specular, 0.25f);
  EXPECT_EQ(s.specular_color, Vec3f(2.0f, 0.5f, 0.0f));
  EXPECT_EQ(s.clearcoat, 0.75f);
  EXPECT_EQ(s.clearcoat_roughness, 0.125f);
}

Json all_maps() {
  const Json map = {{"index", 0}};
  return {{"pbrMetallicRoughness", {{"baseColorTexture", map}, {"metallicRoughnessTexture", map}}},
          {"normalTexture", {{"index", 0}, {"scale", 0.5}}},
          {"occlusionTexture", {{"index", 0}, {"strength", 0.25}}},
          {"emissiveTexture", map},
          {"emissiveFactor", {1, 1, 1}},
          {"extensions",
           {{"KHR_materials_transmission", {{"transmissionFactor", 0.5}, {"transmissionTexture", map}}},
            {"KHR_materials_specular", {{"specularTexture", map}, {"specularColorTexture", map}}},
            {"KHR_materials_clearcoat",
             {{"clearcoatFactor", 1},
              {"clearcoatTexture", map},
              {"clearcoatRoughnessTexture", map},
              {"clearcoatNormalTexture", {{"index", 0}, {"scale", 2}}}}}}}};
}

MetallicRoughness surface_of(const GltfBuilder& b) {
  const Scene scene = parse(b);
  validate(scene, "a.glb");
  return std::get<MetallicRoughness>(scene.materials.at(0).surface);
}

TEST(GltfMaterial, webp_takes_precedence) {
  GltfBuilder b = textured(four_colours());
  b.add("images", {{"bufferView", b.add_view(encode_webp(2, 1, {1, 2, 3, 255, 4, 5, 6, 128}))}, {"mimeType", "image/webp"}});
  b.root["textures"][0]["extensions"]["EXT_texture_webp"]["source"] = 1;
  EXPECT_THAT(parse(b).textures.at(0).rgba, ElementsAre(1, 2, 3, 255, 4, 5, 6, 128));
  b.root["textures"][0].erase("source");  // no image for readers without WebP
  EXPECT_THAT(parse(b).textures.at(0).rgba, ElementsAre(1, 2, 3, 255, 4, 5, 6, 128));
}

TEST(GltfMaterial, glossiness_alpha_becomes_roughness) {
  GltfBuilder b = textured(encode_png(2, 1, 4, {200, 100, 50, 255, 200, 100, 50, 0}));
  b.root["materials"][0]["extensions"]["KHR_materials_pbrSpecularGlossiness"] = {{"glossinessFactor", 0.6},
                                                                                 {"specularGlossinessTexture", {{"index", 0}}}};
  const Scene scene = parse(b);
  const auto& s = std::get<MetallicRoughness>(scene.materials[0].surface);
  EXPECT_EQ(s.roughness, 1.0f);  // the map contains the roughness
  ASSERT_GE(s.metallic_roughness_map.texture, 0);
  const Texture& rough = scene.textures[static_cast<std::size_t>(s.metallic_roughness_map.texture)];
  EXPECT_EQ(rough.rgba[1], 102);  // 255 * (1 - 0.6)
  EXPECT_EQ(rough.rgba[5], 255);
  const Texture& reflectance = scene.textures[static_cast<std::size_t>(s.specular_color_map.texture)];
  EXPECT_TRUE(reflectance.srgb);
  EXPECT_THAT(std::vector(reflectance.rgba.begin(), reflectance.rgba.begin() + 3), ElementsAre(200, 100, 50));
}

TEST(GltfMaterial, anisotropy_s_map_holds_numbers_not_colours) {
  GltfBuilder b = textured(four_colours());
  b.root["materials"][0]["extensions"]["KHR_materials_anisotropy"] = {{"anisotropyStrength", 0.5},
                                                                      {"anisotropyTexture", {{"index", 0}}}};
  const Scene scene = parse(b);
  const auto& s = std::get<MetallicRoughness>(scene.materials[0].surface);
  ASSERT_TRUE(s.extensions);
  ASSERT_GE(s.extensions->anisotropy.map.texture, 0);
  EXPECT_FALSE(scene.textures[static_cast<std::size_t>(s.extensions->anisotropy.map.texture)].srgb);
}

TEST(GltfMaterial, image_is_decoded_for_colours_and_data) {
  GltfBuilder b = textured(four_colours());
  b.root["materials"][0] = all_maps();
  const Scene scene = parse(b);
  ASSERT_EQ(scene.textures.size(), 2u);
  const int colors = scene.textures[0].srgb ? 0 : 1;
  EXPECT_NE(scene.textures[0].srgb, scene.textures[1].srgb);
  const MetallicRoughness s = surface_of(b);
  for (const TextureMap* map : {&s.base_color_map, &s.emissive_map, &s.specular_color_map}) EXPECT_EQ(map->texture, colors);
  for (const TextureMap* map : {&s.metallic_roughness_map, &s.normal_map, &s.occlusion_map, &s.transmission_map,
                                &s.specular_map, &s.clearcoat_map, &s.clearcoat_roughness_map, &s.clearcoat_normal_map})
    EXPECT_EQ(map->texture, 1 - colors);
  EXPECT_EQ(s.normal_scale, 0.5f);
  EXPECT_EQ(s.occlusion_strength, 0.25f);
  EXPECT_EQ(s.clearcoat_normal_scale, 2.0f);
}

TEST(GltfMaterial, skips_maps_without_effect) {
  GltfBuilder b = textured({'n', 'o'});
  Json& material = b.root["materials"][0] = all_maps();
  material["extensions"]["KHR_materials_unlit"] = Json::object();
  material["pbrMetallicRoughness"].clear();
  material["emissiveFactor"] = {0, 0, 0};
  EXPECT_NO_THROW(parse(b));
}

Vec2f look_up(const TextureMap& map, Vec2f uv) { return map.offset + map.matrix * uv; }

MetallicRoughness surface_with_transform(const Json& transform) {
  GltfBuilder b = textured(four_colours());
  b.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = transform;
  return surface_of(b);
}

TEST(GltfTextureTransform, scales_then_turns_then_moves) {
  const TextureMap map =
      surface_with_transform({{"offset", {0.25, 0.5}}, {"scale", {2, 4}}, {"rotation", kPi / 2}}).base_color_map;
  // The transform scales (1, 0) to (2, 0), rotates it by 90 degrees to (0, -2), and translates it.
  const Vec2f along_u = look_up(map, {1, 0}), along_v = look_up(map, {0, 1});
  EXPECT_NEAR(along_u.x, 0.25f, 1e-6f);  // the cosine of pi / 2 is not exactly 0 in floats
  EXPECT_NEAR(along_u.y, -1.5f, 1e-6f);
  EXPECT_NEAR(along_v.x, 4.25f, 1e-6f);
  EXPECT_NEAR(along_v.y, 0.5f, 1e-6f);
}

TEST(GltfTextureTransform, reads_maps_of_extensions) {
  GltfBuilder b = textured(four_colours());
  b.root["materials"][0]["extensions"]["KHR_materials_clearcoat"] = {
      {"clearcoatFactor", 1},
      {"clearcoatTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0}}}}}}}}};
  EXPECT_EQ(surface_of(b).clearcoat_map.offset, Vec2f(0.5f, 0.0f));
}

TEST(GltfTextureTransform, wrong_length_is_an_error) {
  EXPECT_EQ(error_message([] {
              surface_with_transform({{"scale", {1}}});
            }),
            "a.glb: materials[0].pbrMetallicRoughness.baseColorTexture.extensions.KHR_texture_transform.scale: has 1 entries; "
            "accepted: 2");
}

TEST(GltfTexture, png_is_top_row_first_without_premultiplication) {
  const Scene scene = parse(textured(four_colours()));
  ASSERT_EQ(scene.textures.size(), 1u);
  const Texture& texture = scene.textures[0];
  EXPECT_EQ(texture.name, "colours");
  EXPECT_EQ(texture.width, 2);
  EXPECT_EQ(texture.height, 2);
  EXPECT_TRUE(texture.srgb);
  EXPECT_THAT(texture.rgba, ElementsAre(255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 0));
  EXPECT_EQ(std::get<MetallicRoughness>(scene.materials[0].surface).base_color_map.texture, 0);
  EXPECT_NO_THROW(validate(scene, "a.glb"));
}

TEST(GltfTexture, fewer_channels_are_expanded) {
  EXPECT_THAT(parse(textured(encode_png(2, 1, 1, {10, 20}))).textures.at(0).rgba,
              ElementsAre(10, 10, 10, 255, 20, 20, 20, 255));
  EXPECT_THAT(parse(textured(encode_png(2, 1, 2, {10, 11, 20, 22}))).textures.at(0).rgba,
              ElementsAre(10, 10, 10, 11, 20, 20, 20, 22));
  EXPECT_THAT(parse(textured(encode_png(2, 1, 3, {1, 2, 3, 4, 5, 6}))).textures.at(0).rgba,
              ElementsAre(1, 2, 3, 255, 4, 5, 6, 255));
}

TEST(GltfTexture, jpeg_is_decoded) {
  const Scene scene = parse(textured(encode_jpeg(8, 8, 3, std::vector<std::uint8_t>(3 * 64, 128))));
  // JPEG represents a uniform grey of 128 by coefficients of 0, which any quality preserves.
  EXPECT_EQ(scene.textures.at(0).rgba[0], 128);
  EXPECT_EQ(scene.textures.at(0).rgba[3], 255);
}

TEST(GltfTexture, wrap_modes_are_read) {
  const Texture texture = parse(textured(four_colours(), {{"wrapS", 33071}, {"wrapT", 33648}})).textures.at(0);
  EXPECT_EQ(texture.wrap_u, Wrap::kClamp);
  EXPECT_EQ(texture.wrap_v, Wrap::kMirror);
}

TEST(GltfTexture, unknown_wrap_mode_is_an_error) {
  EXPECT_THAT(error_message([] {
                parse(textured(four_colours(), {{"wrapS", 10498}}));
              }),
              HasSubstr("samplers[0]: has the wrap mode 10498; accepted: 10497"));
}

TEST(GltfTexture, nearest_filter_is_a_warning) {
  std::vector<std::string> warnings;
  parse(textured(four_colours(), {{"magFilter", 9728}}), &warnings);
  EXPECT_THAT(warnings, Contains(HasSubstr("nearest-neighbour filtering is not supported")));
}

TEST(GltfTexture, shared_image_is_decoded_once) {
  GltfBuilder b = textured(four_colours());
  b.add("materials", {{"emissiveFactor", {1, 1, 1}}, {"emissiveTexture", {{"index", 0}}}});
  const Scene scene = parse(b);
  EXPECT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(std::get<MetallicRoughness>(scene.materials[1].surface).emissive_map.texture, 0);
}

TEST(GltfTexture, mesh_uses_the_texture_s_uv_set) {
  GltfBuilder b = textured(four_colours());
  b.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 1;
  const int first = b.add_accessor(std::vector<Vec2f>(3, Vec2f(0.25f))),
            second = b.add_accessor(std::vector<Vec2f>(3, Vec2f(0.75f)));
  b.root["meshes"][0]["primitives"][0]["attributes"].update({{"TEXCOORD_0", first}, {"TEXCOORD_1", second}});
  const Scene scene = parse(b);
  EXPECT_THAT(std::get<Mesh>(scene.shapes.at(0)).uvs, testing::Each(Vec2f(0.75f)));
}

/// All texture coordinates of TEXCOORD_n are n / 4. The maps of base colour, emission and occlusion use the given sets.
GltfBuilder with_three_sets(int base, int emissive, int occlusion) {
  GltfBuilder b = textured(four_colours());
  Json& material = b.root["materials"][0];
  material["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = base;
  material.update({{"emissiveFactor", {1, 1, 1}},
                   {"emissiveTexture", {{"index", 0}, {"texCoord", emissive}}},
                   {"occlusionTexture", {{"index", 0}, {"texCoord", occlusion}}}});
  for (int n = 0; n < 3; ++n) {
    const int accessor = b.add_accessor(std::vector<Vec2f>(3, Vec2f(0.25f * static_cast<float>(n))));
    b.root["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_" + std::to_string(n)] = accessor;
  }
  return b;
}

TEST(GltfTexture, reads_two_uv_sets_per_material) {
  const Scene scene = parse(with_three_sets(2, 1, 2));
  const Mesh& mesh = std::get<Mesh>(scene.shapes.at(0));
  EXPECT_THAT(mesh.uvs, testing::Each(Vec2f(0.5f)));
  EXPECT_THAT(mesh.uvs_1, testing::Each(Vec2f(0.25f)));
  const MetallicRoughness s = std::get<MetallicRoughness>(scene.materials[0].surface);
  EXPECT_EQ(s.base_color_map.uv_set, 0);
  EXPECT_EQ(s.emissive_map.uv_set, 1);
  EXPECT_EQ(s.occlusion_map.uv_set, 0);
}

TEST(GltfTexture, third_set_of_coordinates_is_a_warning) {
  std::vector<std::string> warnings;
  const Scene scene = parse(with_three_sets(0, 1, 2), &warnings);
  EXPECT_THAT(warnings, Contains(HasSubstr("more than two sets of texture coordinates in one material are not supported")));
  EXPECT_EQ(std::get<MetallicRoughness>(scene.materials[0].surface).occlusion_map.uv_set, 0);
}

TEST(GltfTexture, transform_may_choose_another_set) {
  GltfBuilder b = with_three_sets(0, 0, 0);
  b.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {{"texCoord", 2}};
  const Scene scene = parse(b);
  EXPECT_THAT(std::get<Mesh>(scene.shapes.at(0)).uvs, testing::Each(Vec2f(0.5f)));
}

std::string warning_about(const std::vector<unsigned char>& image) {
  std::vector<std::string> warnings;
  const Scene scene = parse(textured(image), &warnings);
  EXPECT_EQ(std::get<MetallicRoughness>(scene.materials.at(0).surface).base_color_map.texture, -1);
  EXPECT_TRUE(scene.textures.empty());
  return warnings.size() == 1 ? warnings[0] : "(not one warning)";
}

std::string left_out_image(const std::string& what) {
  return "a.glb: an image is " + what +
         " (accepted: PNG, JPEG, WebP, BMP, TIFF, GIF, TGA); the surface is shown without it (first at images[0])";
}

TEST(GltfTexture, unknown_image_format_is_a_warning) {
  EXPECT_EQ(warning_about({'D', 'D', 'S', ' '}), left_out_image("a DDS texture"));
  EXPECT_EQ(warning_about({0xab, 'K', 'T', 'X', ' ', '1', '1', 0xbb, '\r', '\n', 0x1a, '\n'}), left_out_image("a KTX texture"));
}

TEST(GltfTexture, other_programs_pictures_are_read) {
  using namespace std::literals;
  // one pixel of 24 bits: blue 30, green 20, red 10
  const std::string bmp =
      "BM\x3a\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\1\0\0\0\1\0\0\0\1\0\x18\0"s + std::string(24, '\0') + "\x1e\x14\x0a\0"s;
  std::vector<std::string> warnings;
  const Scene scene = parse(textured({bmp.begin(), bmp.end()}), &warnings);
  EXPECT_THAT(warnings, testing::IsEmpty());
  EXPECT_THAT(scene.textures.at(0).rgba, testing::ElementsAre(10, 20, 30, 255));
}

TEST(GltfTexture, ktx2_image_gets_advice) {
  const std::vector<unsigned char> ktx2{0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb, '\r', '\n', 0x1a, '\n', 0, 0};
  EXPECT_THAT(warning_about(ktx2), HasSubstr("a.glb: an image is a KTX2 file: convert to PNG first, with gltf-transform "
                                             "ktxdecompress IN OUT"));
}

TEST(GltfTexture, every_png_prefix_is_an_error) {
  const std::vector<unsigned char> whole = four_colours();
  for (std::size_t length = 1; length < whole.size(); ++length) {
    const std::vector<unsigned char> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
    if (length < 8)
      EXPECT_THAT(warning_about(cut), HasSubstr("(accepted: PNG, JPEG, WebP, BMP, TIFF, GIF, TGA); the surface is shown"))
          << "cut to " << length;
    else
      EXPECT_EQ(error_message([&] { parse(textured(cut)); }),
                "a.glb: images[0]: cannot be read as a picture: the file is truncated")
          << "cut to " << length;
  }
}

TEST(GltfTexture, png_with_damaged_pixels_is_an_error) {
  std::vector<unsigned char> damaged = four_colours();
  // The pixels are followed by a checksum of 4 bytes and the last chunk of 12 bytes.
  damaged[damaged.size() - 12 - 4 - 6] ^= 0xff;
  EXPECT_THAT(error_message([&] { parse(textured(damaged)); }), HasSubstr("a.glb: images[0]: cannot be read as a picture"));
}

TEST(GltfTexture, too_large_image_is_rejected_before_decoding) {
  GltfLimits limits;
  limits.texture_side = 1;
  EXPECT_EQ(error_message([&] { parse(textured(four_colours()), nullptr, limits); }),
            "a.glb: images[0]: has 2 x 2 pixels; accepted: 1 to 1 pixels per side");
}

TEST(GltfTexture, images_beyond_the_limit_are_halved) {
  GltfBuilder b = textured(four_colours());
  b.add("images", b.root["images"][0]);
  b.add("textures", {{"source", 1}});
  b.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 1}}}}}});
  std::vector<std::string> warnings;
  const Scene scene = parse(b, &warnings, {}, {.texture_bytes = 31});
  ASSERT_EQ(scene.textures.size(), 2u);
  EXPECT_EQ(scene.textures[0].rgba.size(), 16u);
  EXPECT_EQ(scene.textures[1].rgba.size(), 4u);
  EXPECT_THAT(warnings, testing::ElementsAre(HasSubstr("1 of 2 textures are reduced to half of their resolution")));
}

TEST(GltfTexture, single_image_beyond_the_limit_is_rejected) {
  EXPECT_EQ(error_message([&] { parse(textured(four_colours()), nullptr, {}, {.texture_bytes = 15}); }),
            "a.glb: images[0]: has 2 x 2 pixels, which take too much memory; accepted: at most 0 MB at 4 bytes per pixel "
            "(texture-memory)");
}

TEST(GltfTexture, missing_or_outside_image_is_a_warning) {
  for (const std::string uri : {"none.png", "/etc/none.png", "../none.png", "https://example.org/a.png"}) {
    GltfBuilder b = textured({1});
    b.root["images"][0] = {{"uri", uri}};
    std::vector<std::string> warnings;
    const Scene scene = parse(b, &warnings);
    EXPECT_TRUE(scene.textures.empty());
    EXPECT_THAT(warnings, testing::ElementsAre(testing::AllOf(HasSubstr(uri), HasSubstr("the surface is shown without it"))));
  }
}

TEST(GltfTexture, image_without_a_source_is_an_error) {
  GltfBuilder b = textured(four_colours());
  b.root["images"][0].erase("bufferView");
  EXPECT_EQ(error_message([&] { parse(b); }), "a.glb: images[0]: has neither a uri nor a buffer view");
}

TEST(GltfTexture, missing_image_is_white_with_warning) {
  GltfBuilder b = textured(four_colours());
  b.root["textures"][0].erase("source");
  std::vector<std::string> warnings;
  const Scene scene = parse(b, &warnings);
  EXPECT_EQ(std::get<MetallicRoughness>(scene.materials[0].surface).base_color_map.texture, -1);
  EXPECT_THAT(warnings, Contains("a.glb: textures without a PNG, JPEG or WebP image are white (first at textures[0])"));
}

TEST(GltfTexture, skips_unused_images) {
  GltfBuilder b = textured({'n', 'o'});
  b.root["materials"][0].clear();
  EXPECT_NO_THROW(parse(b));
}

}  // namespace
}  // namespace lippmann
