#include "lippmann/stage/lighting.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lippmann/scene/timeline.hpp"
#include "stage/room.hpp"
#include "stage/surroundings.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

Scene room_seen_from(Vec3f position) {
  Scene scene = test::room_of_six_walls();
  Node node;
  node.local.translation = position;
  Camera camera;
  camera.node = static_cast<int>(scene.nodes.size());
  scene.nodes.push_back(node);
  scene.cameras.push_back(camera);
  return scene;
}

TEST(MissingLight, of_closed_rooms_is_a_viewer_lamp) {
  Scene scene = room_seen_from({0.2f, 0.1f, 0.7f});
  EXPECT_THAT(add_missing_light(scene, Integrator::kPath), HasSubstr("A lamp at the viewer lights the scene"));
  ASSERT_EQ(scene.lights.size(), 1u);
  const Vec3f lamp = evaluate(scene, 0.0).of(scene.lights[0].node).translation;
  EXPECT_NEAR(glm::distance(lamp, Vec3f(0.2f, 0.1f, 0.7f)), 0.0f, 1e-5f);
  EXPECT_FALSE(scene.lights[0].inverse_square) << "rooms of all sizes are equally bright";
}

TEST(MissingLight, scales_and_rotates_the_scenes_panorama) {
  Scene scene = room_seen_from({0.0f, 0.0f, 4.0f});
  scene.background.map = EnvironmentMap{Image(2, 1, 3), 3.0f, 0.0f};
  EXPECT_THAT(light_for_paths(scene, {.strength = 2.0f, .rotation_deg = 90.0f}), HasSubstr("its own light"));
  EXPECT_EQ(scene.background.map->strength, 6.0f);
  EXPECT_FLOAT_EQ(scene.background.map->rotation, 0.5f * kPi);
  EXPECT_TRUE(scene.lights.empty());
}

TEST(MissingLight, of_rooms_seen_from_outside_is_the_studio) {
  Scene scene = room_seen_from({0.0f, 0.0f, 4.0f});
  EXPECT_THAT(add_missing_light(scene, Integrator::kPath), HasSubstr("The built-in studio lights the scene"));
  EXPECT_TRUE(scene.lights.empty());
}

TEST(MissingLight, below_a_dome_is_a_viewer_lamp) {
  Scene scene = test::room_of_six_walls();
  const Scene dome = test::room_of_six_walls(100.0f);
  for (Instance instance : dome.instances) {
    instance.node += static_cast<int>(scene.nodes.size());
    scene.instances.push_back(instance);
  }
  scene.nodes.insert(scene.nodes.end(), dome.nodes.begin(), dome.nodes.end());
  EXPECT_THAT(add_missing_light(scene, Integrator::kPath), HasSubstr("A lamp at the viewer lights the scene"));
  ASSERT_EQ(scene.lights.size(), 1u);
  const Vec3f lamp = evaluate(scene, 0.0).of(scene.lights[0].node).translation;
  EXPECT_GT(glm::length(lamp), 2.0f);
  EXPECT_LT(glm::length(lamp), 20.0f);
}

TEST(MissingLight, of_closed_rooms_with_lamps_is_dim) {
  Scene scene = room_seen_from({0.0f, 0.0f, 0.5f});
  Light light;
  light.node = 0;
  scene.lights.push_back(light);
  EXPECT_THAT(add_missing_light(scene, Integrator::kPath), HasSubstr("The file's lamps light the scene"));
  EXPECT_EQ(scene.lights.size(), 1u);
}

}  // namespace
}  // namespace lippmann
