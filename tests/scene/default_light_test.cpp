#include "scene/default_light.hpp"

#include <gtest/gtest.h>

#include "lippmann/scene/load.hpp"
#include "lippmann/scene/timeline.hpp"
#include "scene/default_view.hpp"

namespace lippmann {
namespace {

Scene scene_of(const MetallicRoughness& surface) {
  Scene scene;
  scene.materials.push_back({"", surface});
  scene.shapes.push_back(Spheres{Sphere{}});
  scene.instances.push_back({"", 0, 0, -1});
  return scene;
}

Vec3f direction_of_light(const Scene& scene) {
  return glm::normalize(transform_vector(evaluate(scene, 0.0).of(scene.lights.at(0).node), {0, 0, -1}));
}

TEST(DefaultLight, is_lacking_where_surfaces_wait_for_light) {
  MetallicRoughness plain, unlit, lamp;
  unlit.unlit = true;
  lamp.emissive = Vec3f(1.0f);
  EXPECT_TRUE(lacks_lamps(scene_of(plain)));
  EXPECT_FALSE(lacks_lamps(scene_of(unlit))) << "nothing to light";
  EXPECT_TRUE(lacks_lamps(scene_of(lamp))) << "its light goes nowhere";
  Scene lit = scene_of(plain);
  lit.lights.emplace_back();
  EXPECT_FALSE(lacks_lamps(lit));
  for (Light& light : lit.lights) light.color = Vec3f(0.0f);
  EXPECT_TRUE(lacks_lamps(lit)) << "black lamps";
  EXPECT_EQ(own_light(lit), OwnLight::kNone);
  for (Light& light : lit.lights) light.color = Vec3f(1e-42f);
  EXPECT_TRUE(lacks_lamps(lit)) << "lamps whose light is rounded to 0";
  EXPECT_EQ(own_light(lit), OwnLight::kNone);
}

Scene scene_of(const PhongSurface& surface) {
  Scene scene = scene_of(MetallicRoughness{});
  scene.materials[0].surface = surface;
  return scene;
}

TEST(DefaultLight, phong_scenes_keep_their_darkness) {
  PhongSurface shown, black, emitter, backdrop;
  black.ambient = emitter.ambient = 0.0f;
  emitter.emission = Vec3f(1.0f);
  backdrop.ambient = 1.0f, backdrop.diffuse = 0.0f;
  EXPECT_FALSE(lacks_lamps(scene_of(shown))) << "its ambient light is the author's";
  EXPECT_TRUE(lacks_lamps(scene_of(black))) << "nothing would be seen";
  EXPECT_FALSE(lacks_lamps(scene_of(emitter)));
  EXPECT_FALSE(lacks_lamps(scene_of(backdrop)));
  Scene lit = scene_of(black);
  lit.lights.emplace_back();
  EXPECT_FALSE(lacks_lamps(lit));
}

TEST(OwnLight, of_phong_scenes_is_what_paths_find) {
  PhongSurface shown, emitter, backdrop;
  emitter.emission = Vec3f(1.0f);
  backdrop.ambient = 1.0f, backdrop.diffuse = 0.0f;
  EXPECT_EQ(own_light(scene_of(shown)), OwnLight::kNone) << "paths have no ambient light";
  EXPECT_EQ(own_light(scene_of(emitter)), OwnLight::kLamps);
  EXPECT_EQ(own_light(scene_of(backdrop)), OwnLight::kNotNeeded);
}

/// A triangle of area 50 with the default surface, and one of area 0.5 with `surface`.
Scene large_and_small(const MetallicRoughness& surface) {
  Scene scene;
  scene.materials = {{"", MetallicRoughness{}}, {"", surface}};
  for (const float side : {10.0f, 1.0f}) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {side, 0, 0}, {0, side, 0}};
    mesh.triangles = {{0, 1, 2}};
    scene.instances.push_back({"", static_cast<int>(scene.shapes.size()), static_cast<int>(scene.shapes.size()), -1});
    scene.shapes.emplace_back(mesh);
  }
  return scene;
}

TEST(OwnLight, found_with_lamps_or_a_sky) {
  Scene scene = large_and_small({});
  EXPECT_EQ(own_light(scene), OwnLight::kNone);
  scene.lights.emplace_back();
  EXPECT_EQ(own_light(scene), OwnLight::kLamps);
  scene.background.zenith = Vec3f(0.1f);
  EXPECT_EQ(own_light(scene), OwnLight::kSurroundings);
}

TEST(OwnLight, emission_counts_averaged_over_all_surfaces) {
  MetallicRoughness lamp;
  lamp.emissive = Vec3f(3.0f);
  EXPECT_EQ(own_light(large_and_small(lamp)), OwnLight::kLamps) << "3 x 0.5 / 50.5 = 0.0297";
  lamp.emissive = Vec3f(1.0f);
  EXPECT_EQ(own_light(large_and_small(lamp)), OwnLight::kNone) << "1 x 0.5 / 50.5 = 0.0099";
}

TEST(OwnLight, is_none_where_only_pictures_shine) {
  MetallicRoughness screen;
  screen.emissive = Vec3f(3.0f);
  screen.emissive_map.texture = 0;
  EXPECT_EQ(own_light(large_and_small(screen)), OwnLight::kNone);
}

TEST(OwnLight, not_needed_by_unlit_surfaces) {
  MetallicRoughness unlit;
  unlit.unlit = true;
  EXPECT_EQ(own_light(scene_of(unlit)), OwnLight::kNotNeeded);
}

TEST(DefaultLight, comes_from_above_left_of_the_viewer) {
  Scene scene = scene_of(MetallicRoughness{});
  add_default_light(scene);
  const Vec3f direction = glm::inverse(default_view()) * direction_of_light(scene);  // in the viewer's frame
  EXPECT_GT(direction.x, 0.0f);
  EXPECT_LT(direction.y, 0.0f);
  EXPECT_LT(direction.z, 0.0f);
  EXPECT_GT(scene.background.horizon.x, 0.0f);
  EXPECT_NO_THROW(validate(scene, "scene"));
}

TEST(DefaultLight, leaves_a_background_as_it_is) {
  Scene scene = scene_of(MetallicRoughness{});
  scene.background.zenith = Vec3f(0.1f, 0.2f, 0.3f);
  add_default_light(scene);
  EXPECT_EQ(scene.background.zenith, Vec3f(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(scene.background.horizon, Vec3f(0.0f));
}

TEST(DefaultLight, comes_from_above_left_of_the_camera) {
  Scene scene = scene_of(MetallicRoughness{});
  Node node;
  const float half_root = std::sqrt(0.5f);
  node.local.rotation = {half_root, 0, half_root, 0};
  node.local.scale = Vec3f(2.0f);
  scene.nodes.push_back(node);
  scene.cameras.emplace_back().node = 0;
  add_default_light(scene);
  const Vec3f direction = direction_of_light(scene);
  EXPECT_LT(direction.x, 0.0f);
  EXPECT_LT(direction.y, 0.0f);
  EXPECT_LT(direction.z, 0.0f);  // to the right, which is -z for this viewer
}

}  // namespace
}  // namespace lippmann
