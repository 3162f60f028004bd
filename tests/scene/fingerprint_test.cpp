#include "scene/fingerprint.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace lippmann {
namespace {

Scene small_scene() {
  Scene scene;
  scene.name = "small";
  scene.nodes.push_back({"root", -1, {}, {}});
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  scene.shapes = {mesh, Spheres{{}}};
  scene.textures.push_back({"t", 1, 1, {1, 2, 3, 4}, true, Wrap::kRepeat, Wrap::kRepeat});
  scene.materials = {{"m", PhongSurface{}}, {"n", MetallicRoughness{}}};
  scene.instances = {{"i", 0, 0, 0}};
  scene.lights.push_back({});
  scene.cameras.push_back({});
  scene.timeline.animations.push_back({0, {{0.0, 1.0}, {Vec3f(0.0f), Vec3f(1.0f)}, Interpolation::kLinear}, {}, {}});
  return scene;
}

TEST(SceneFingerprint, names_do_not_change_it) {
  Scene renamed = small_scene();
  renamed.name = "other";
  renamed.nodes[0].name = "other";
  EXPECT_EQ(fingerprint(small_scene()), fingerprint(renamed));
}

TEST(SceneFingerprint, any_visible_change_changes_it) {
  const std::vector<std::function<void(Scene&)>> changes{
      [](Scene& s) { std::get<Mesh>(s.shapes[0]).positions[1].x = 2.0f; },
      [](Scene& s) {
        std::get<Mesh>(s.shapes[0]).triangles[0] = {0, 2, 1};
      },
      [](Scene& s) { std::get<Spheres>(s.shapes[1])[0].radius = 2.0f; },
      [](Scene& s) { std::get<Spheres>(s.shapes[1]).push_back({}); },
      [](Scene& s) { s.textures[0].rgba[3] = 5; },
      [](Scene& s) { s.textures[0].wrap_v = Wrap::kClamp; },
      [](Scene& s) { std::get<PhongSurface>(s.materials[0].surface).projection = ImageProjection{}; },
      [](Scene& s) { std::get<MetallicRoughness>(s.materials[1].surface).unlit = true; },
      [](Scene& s) {
        std::get<Mesh>(s.shapes[0]).alphas = {1, 1, 0};
      },
      [](Scene& s) { std::get<Mesh>(s.shapes[0]).targets.resize(1); },
      [](Scene& s) { std::get<Mesh>(s.shapes[0]).skin.per_vertex = 1; },
      [](Scene& s) { std::get<MetallicRoughness>(s.materials[1].surface).emissive_map.offset.y = 0.5f; },
      [](Scene& s) { std::get<MetallicRoughness>(s.materials[1].surface).normal_map.matrix[1].x = 0.5f; },
      [](Scene& s) {
        s.skins.push_back({"s", {0}, {Affine3f{}}});
      },
      [](Scene& s) { s.instances[0].skin = 0; },
      [](Scene& s) { s.lights[0].radius = 0.5f; },
      [](Scene& s) { s.lights[0].angular_diameter = 0.5f; },
      [](Scene& s) { s.lights[0].smooth_edge = true; },
      [](Scene& s) { s.cameras[0].orthographic_height = 2.0f; },
      [](Scene& s) { s.cameras[0].near_distance = 0.1f; },
      [](Scene& s) { s.cameras[0].shift.y = 0.5f; },
      [](Scene& s) { s.nodes[0].morph_weights = {1.0f}; },
      [](Scene& s) {
        s.timeline.animations[0].morph_weights = {{0.0}, {1.0f}};
      },
      [](Scene& s) { s.instances[0].material = 1; },
      [](Scene& s) { s.lights[0].color.y = 0.5f; },
      [](Scene& s) { s.cameras[0].vertical_fov = 1.0f; },
      [](Scene& s) { s.display = DisplayPlacement{}; },
      [](Scene& s) { s.background.zenith.z = 1.0f; },
      [](Scene& s) { s.timeline.animations[0].translation.values[1].x = 2.0f; },
      [](Scene& s) { s.timeline.frame_count = 2; },
      [](Scene& s) { s.nodes[0].local.rotation.w = 0.5f; },
      [](Scene& s) { s.nodes[0].matrix = Affine3f{}; },
      [](Scene& s) { s.encoding = Encoding::kTachyonTruncate; },
      [](Scene& s) { s.max_depth = 1; },
  };
  const std::uint64_t original = fingerprint(small_scene());
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Scene changed = small_scene();
    changes[i](changed);
    EXPECT_NE(fingerprint(changed), original) << "change " << i;
  }
}

}  // namespace
}  // namespace lippmann
