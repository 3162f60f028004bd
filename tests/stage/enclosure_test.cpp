#include "stage/enclosure.hpp"

#include <gtest/gtest.h>

#include "stage/room.hpp"

namespace lippmann {
namespace {

bool is_enclosed_at(const Scene& scene, Vec3f point) { return is_enclosed(scene, evaluate(scene, 0.0), point); }

TEST(Enclosure, six_walls_enclose_a_room) {
  const Scene scene = test::room_of_six_walls();
  for (const Vec3f point : {Vec3f(0.0f), Vec3f(0.9f, -0.8f, 0.7f), Vec3f(-0.99f)}) EXPECT_TRUE(is_enclosed_at(scene, point));
  EXPECT_FALSE(is_enclosed_at(scene, {0.0f, 0.0f, 1.5f})) << "outside";
}

TEST(Enclosure, open_rooms_are_not_enclosed) {
  for (std::size_t wall = 0; wall < 6; ++wall) {
    Scene scene = test::room_of_six_walls();
    scene.instances.erase(scene.instances.begin() + static_cast<std::ptrdiff_t>(wall));
    EXPECT_FALSE(is_enclosed_at(scene, Vec3f(0.0f))) << wall;
  }
}

TEST(Enclosure, clear_and_glowing_walls_give_light) {
  using Change = void (*)(MetallicRoughness&);
  for (const Change change : {Change([](MetallicRoughness& wall) { wall.transmission = 1.0f; }),
                              Change([](MetallicRoughness& wall) { wall.blend = true; }),
                              Change([](MetallicRoughness& wall) { wall.alpha_cutoff = 0.5f; }),
                              Change([](MetallicRoughness& wall) { wall.unlit = true; }),
                              Change([](MetallicRoughness& wall) { wall.emissive = Vec3f(1.0f); })}) {
    Scene scene = test::room_of_six_walls();
    MetallicRoughness other;
    change(other);
    scene.materials.push_back({"other", other});
    scene.instances[3].material = 1;
    EXPECT_FALSE(is_enclosed_at(scene, Vec3f(0.0f)));
  }
}

TEST(Enclosure, lights_behind_walls_do_not_count) {
  Scene scene = test::room_of_six_walls();
  MetallicRoughness shining;
  shining.emissive = Vec3f(1.0f);
  scene.materials.push_back({"shining", shining});
  const Scene around = test::room_of_six_walls(2.0f);
  for (Instance instance : around.instances) {
    instance.node += static_cast<int>(scene.nodes.size()), instance.material = 1;
    scene.instances.push_back(instance);
  }
  scene.nodes.insert(scene.nodes.end(), around.nodes.begin(), around.nodes.end());
  EXPECT_TRUE(is_enclosed_at(scene, Vec3f(0.0f)));
  EXPECT_FALSE(is_enclosed_at(scene, Vec3f(1.5f))) << "between the rooms";
}

TEST(Enclosure, follows_a_moved_room) {
  Scene scene = test::room_of_six_walls(50.0f, {300.0f, 0.0f, 0.0f});
  EXPECT_TRUE(is_enclosed_at(scene, {340.0f, 30.0f, -20.0f}));
  EXPECT_FALSE(is_enclosed_at(scene, Vec3f(0.0f)));
}

}  // namespace
}  // namespace lippmann
