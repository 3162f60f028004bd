#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/gltf/gltf_builder.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using test::GltfBuilder;
using test::Json;
using test::parse;
using testing::HasSubstr;

GltfBuilder with_extensions(const Json& extensions) {
  GltfBuilder b;
  b.add("materials", {{"extensions", extensions}});
  b.add_node({{"mesh", b.add_triangle({{"material", 0}})}});
  b.add("scenes", {{"nodes", {0}}});
  return b;
}

MetallicRoughness surface_with(const Json& extensions) {
  const Scene scene = parse(with_extensions(extensions));
  validate(scene, "a.glb");
  return std::get<MetallicRoughness>(scene.materials.at(0).surface);
}

Json glass(const Json& volume) {
  return {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}, {"KHR_materials_volume", volume}};
}

TEST(GltfVolume, of_some_thickness_is_solid_and_absorbs) {
  const MetallicRoughness s =
      surface_with(glass({{"thicknessFactor", 2}, {"attenuationDistance", 0.5}, {"attenuationColor", {1, 0.5, 0.25}}}));
  ASSERT_TRUE(s.extensions && s.extensions->volume);
  EXPECT_TRUE(s.extensions->volume->is_solid);
  EXPECT_EQ(s.extensions->volume->attenuation_distance, 0.5f);
  EXPECT_EQ(s.extensions->volume->attenuation_color, Vec3f(1.0f, 0.5f, 0.25f));
}

TEST(GltfVolume, of_no_thickness_is_a_thin_wall) {
  const MetallicRoughness s = surface_with(glass(Json::object()));
  ASSERT_TRUE(s.extensions && s.extensions->volume);
  EXPECT_FALSE(s.extensions->volume->is_solid);
  EXPECT_EQ(s.extensions->volume->attenuation_distance, kInfinity);
}

TEST(GltfVolume, behind_an_opaque_surface_is_nothing) {
  EXPECT_FALSE(surface_with({{"KHR_materials_volume", {{"thicknessFactor", 1}}}}).extensions);
}

TEST(GltfVolume, zero_and_huge_distances_are_infinite) {
  for (const double distance : {0.0, 1e300}) {
    const MetallicRoughness s = surface_with(glass({{"thicknessFactor", 1}, {"attenuationDistance", distance}}));
    EXPECT_EQ(s.extensions->volume->attenuation_distance, kInfinity) << distance;
  }
}

TEST(GltfDispersion, of_what_reflects_everything_is_none) {
  Json extensions = glass({{"thicknessFactor", 1}});
  extensions["KHR_materials_dispersion"] = {{"dispersion", 5}};
  EXPECT_EQ(surface_with(extensions).extensions->dispersion, 5.0f);
  extensions["KHR_materials_ior"] = {{"ior", 0}};
  EXPECT_EQ(surface_with(extensions).extensions->dispersion, 0.0f);
}

struct BadValue {
  const char *extension, *property;
  Json value;
  const char* message;
};

TEST(GltfMaterialExtensions, bad_values_are_refused_by_name) {
  const BadValue bad[] = {
      {"KHR_materials_volume", "thicknessFactor", -1, "thicknessFactor: is -1"},
      {"KHR_materials_volume", "thicknessFactor", nullptr, "thicknessFactor: is not a number"},
      {"KHR_materials_volume", "attenuationDistance", -0.5, "attenuationDistance: is -0.5"},
      {"KHR_materials_volume", "attenuationColor", {1, 2, 1}, "attenuationColor[1]: is 2"},
      {"KHR_materials_ior", "ior", 1e30, "ior: is 1e+30; accepted: 0 to 1000"},
      {"KHR_materials_sheen", "sheenColorFactor", {1, 1}, "sheenColorFactor: has 2 entries"},
      {"KHR_materials_sheen", "sheenRoughnessFactor", 1.5, "sheenRoughnessFactor: is 1.5"},
      {"KHR_materials_anisotropy", "anisotropyStrength", -0.1, "anisotropyStrength: is -0.1"},
      {"KHR_materials_iridescence", "iridescenceIor", 0, "iridescenceIor: is 0"},
      {"KHR_materials_iridescence", "iridescenceThicknessMaximum", -400, "iridescenceThicknessMaximum: is -400"},
      {"KHR_materials_diffuse_transmission", "diffuseTransmissionFactor", 2, "diffuseTransmissionFactor: is 2"},
      {"KHR_materials_dispersion", "dispersion", -1, "dispersion: is -1"},
      {"KHR_materials_pbrSpecularGlossiness", "glossinessFactor", "x", "glossinessFactor: is not a number"},
  };
  for (const BadValue& b : bad)
    EXPECT_THAT(error_message([&] { parse(with_extensions({{b.extension, {{b.property, b.value}}}})); }), HasSubstr(b.message));
}

TEST(GltfMaterialExtensions, lobes_are_read) {
  const MetallicRoughness s =
      surface_with({{"KHR_materials_sheen", {{"sheenColorFactor", {0.5, 0.25, 1}}, {"sheenRoughnessFactor", 0.75}}},
                    {"KHR_materials_anisotropy", {{"anisotropyStrength", 0.5}, {"anisotropyRotation", 1.5}}},
                    {"KHR_materials_iridescence", {{"iridescenceFactor", 1}, {"iridescenceThicknessMinimum", 200}}},
                    {"KHR_materials_diffuse_transmission",
                     {{"diffuseTransmissionFactor", 0.25}, {"diffuseTransmissionColorFactor", {1, 0.5, 0}}}}});
  ASSERT_TRUE(s.extensions);
  EXPECT_EQ(s.extensions->sheen.color, Vec3f(0.5f, 0.25f, 1.0f));
  EXPECT_EQ(s.extensions->sheen.roughness, 0.75f);
  EXPECT_EQ(s.extensions->anisotropy.strength, 0.5f);
  EXPECT_EQ(s.extensions->anisotropy.rotation, 1.5f);
  EXPECT_EQ(s.extensions->iridescence.share, 1.0f);
  EXPECT_EQ(s.extensions->iridescence.ior, 1.3f);
  EXPECT_EQ(s.extensions->iridescence.least_thickness_nm, 200.0f);
  EXPECT_EQ(s.extensions->iridescence.most_thickness_nm, 400.0f);
  EXPECT_EQ(s.extensions->diffuse_transmission.share, 0.25f);
  EXPECT_EQ(s.extensions->diffuse_transmission.color, Vec3f(1.0f, 0.5f, 0.0f));
}

TEST(GltfMaterialExtensions, without_effect_leave_the_common_surface) {
  EXPECT_FALSE(surface_with({{"KHR_materials_sheen", {{"sheenRoughnessFactor", 0.5}}},
                             {"KHR_materials_anisotropy", Json::object()},
                             {"KHR_materials_iridescence", Json::object()},
                             {"KHR_materials_diffuse_transmission", Json::object()},
                             {"KHR_materials_dispersion", {{"dispersion", 1}}}})
                   .extensions);
}

TEST(GltfMaterialExtensions, dispersion_is_that_of_solid_glass) {
  Json thick = glass({{"thicknessFactor", 1}}), thin = glass(Json::object());
  thick["KHR_materials_dispersion"] = thin["KHR_materials_dispersion"] = {{"dispersion", 0.5}};
  EXPECT_EQ(surface_with(thick).extensions->dispersion, 0.5f);
  EXPECT_EQ(surface_with(thin).extensions->dispersion, 0.0f);
}

TEST(GltfSpecularGlossiness, is_a_dielectric_of_that_reflectance) {
  const MetallicRoughness s = surface_with(
      {{"KHR_materials_pbrSpecularGlossiness",
        {{"diffuseFactor", {0.5, 0.25, 0, 1}}, {"specularFactor", {0.75, 0.5, 0.25}}, {"glossinessFactor", 0.75}}}});
  EXPECT_EQ(s.metallic, 0.0f);
  EXPECT_EQ(s.roughness, 0.25f);
  EXPECT_EQ(Vec3f(s.base_color), Vec3f(0.5f, 0.25f, 0.0f));
  EXPECT_EQ(s.specular_color, Vec3f(0.75f, 0.5f, 0.25f));
  EXPECT_GT(s.ior, 500.0f);  // reflects all light, multiplied by the specular colour
}

GltfBuilder with_variants() {
  GltfBuilder b;
  for (const char* name : {"Plain", "Painted"}) b.add("materials", {{"name", name}});
  const Json mapping = {{"material", 1}, {"variants", {0, 2}}};
  b.add_node(
      {{"mesh", b.add_triangle({{"material", 0}, {"extensions", {{"KHR_materials_variants", {{"mappings", {mapping}}}}}}})}});
  b.add("scenes", {{"nodes", {0}}});
  b.root["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "Beach"}}, {{"name", "Bare"}}, {{"name", "Street"}}};
  return b;
}

int shown_material(const GltfBuilder& b, const std::string& variant) {
  return parse_gltf(b.glb(), "a.glb", {.variant = variant}, Context()).instances.at(0).material;
}

TEST(GltfVariants, are_chosen_by_name_or_index) {
  const GltfBuilder b = with_variants();
  EXPECT_EQ(shown_material(b, ""), 0);
  EXPECT_EQ(shown_material(b, "Beach"), 1);
  EXPECT_EQ(shown_material(b, "2"), 1);
  EXPECT_EQ(shown_material(b, "Bare"), 0);
  EXPECT_THAT(parse(b).variant_names, testing::ElementsAre("Beach", "Bare", "Street"));
}

TEST(GltfVariants, unknown_variant_is_an_error_with_names) {
  EXPECT_THAT(error_message([] { shown_material(with_variants(), "Snow"); }),
              HasSubstr("'Snow' is not in the file; accepted: Beach (0), Bare (1), Street (2)"));
  EXPECT_THAT(error_message([] { shown_material(with_extensions(Json::object()), "Beach"); }),
              HasSubstr("the file has no material variants"));
}

TEST(GltfVariants, invalid_mappings_are_errors) {
  const auto message = [](const Json& mappings) {
    GltfBuilder b = with_variants();
    b.root["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"] = mappings;
    return error_message([&] { shown_material(b, "Beach"); });
  };
  EXPECT_THAT(message({{{"material", 1}, {"variants", {3}}}}),
              HasSubstr("refers to variants[3], but the number of variants is 3"));
  EXPECT_THAT(message({{{"material", 2}, {"variants", {0}}}}),
              HasSubstr("refers to materials[2], but the number of materials is 2"));
  EXPECT_THAT(message({{{"material", 0}, {"variants", {0}}}, {{"material", 1}, {"variants", {0}}}}),
              HasSubstr("two materials for one variant"));
}

}  // namespace
}  // namespace lippmann
