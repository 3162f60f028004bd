#include <cmath>

#include "bench/hostile_builders.hpp"
#include "bench/hostile_parts.hpp"
#include "scene/builtin/meshes.hpp"

namespace lippmann::bench {
namespace {

void add_ceiling_lamp(Scene& scene) { add_lamp(scene, {0.0f, 1.98f, 0.2f}, 0.35f, Vec3f(12.0f, 11.3f, 10.0f)); }

void look_into_ball_room(Scene& scene) { look_at(scene, {0.0f, 0.8f, 0.0f}, radians(4.0f), radians(10.0f), 1.8f, 3.6f); }

Mesh ball(float radius) { return builtin::uv_sphere(radius, 48, 24); }

}  // namespace

Scene mirror_walls() {
  Scene scene = empty_scene("mirrors");
  Room room = painted_room(scene);
  room.left = room.rear = add_material(scene, metal(Vec3f(0.9f), 0.0f));
  room.right = add_material(scene, metal({0.85f, 0.8f, 0.7f}, 0.0f));
  room.floor = add_textured(scene, matte(Vec3f(1.0f)), checker(Vec3f(0.7f), {0.25f, 0.3f, 0.4f}));
  room.tile = 0.5f;
  add_room(scene, room);
  // The lamp is large, because paths that leave a mirror hit it only by chance.
  add_lamp(scene, {0.0f, 1.98f, 0.5f}, 1.2f, Vec3f(1.9f, 1.8f, 1.6f));
  constexpr float kRadius = 0.3f, kStep = 0.1f;
  const int roller = add_node(scene, -1);
  move(scene, roller, [](float frame) { return Vec3f(-0.8f + kStep * frame, kRadius, 0.0f); });
  turn(scene, roller, {0.0f, 0.0f, -1.0f}, [](float frame) { return kStep / kRadius * frame; });
  show(scene, ball(kRadius), add_textured(scene, matte(Vec3f(1.0f)), checker({0.8f, 0.2f, 0.1f}, {0.8f, 0.7f, 0.5f})), roller);
  show(scene, box_mesh({0.6f, 0.5f, -0.7f}, {0.25f, 1.0f, 0.25f}), add_material(scene, matte({0.2f, 0.5f, 0.6f})));
  look_into_ball_room(scene);
  return scene;
}

Scene glass_things() {
  Scene scene = empty_scene("glass");
  Room room = painted_room(scene);
  room.rear = add_textured(scene, matte(Vec3f(1.0f)), checker({0.75f, 0.7f, 0.6f}, {0.25f, 0.15f, 0.12f}));
  room.tile = 0.4f;
  add_room(scene, room);
  add_lamp(scene, {0.0f, 1.98f, 0.0f}, 0.6f, Vec3f(4.0f, 3.8f, 3.4f));
  const int glass = add_material(scene, clear_glass());
  const int slider = add_node(scene, -1);
  move(scene, slider, [](float frame) { return Vec3f(-0.7f + 0.06f * frame, 0.55f, 0.2f); });
  show(scene, ball(0.42f), glass, slider);
  const int turner = add_node(scene, -1, {0.7f, 0.45f, -0.3f});
  turn(scene, turner, kUp, [](float frame) { return radians(6.0f) * frame; });
  show(scene, box_mesh(Vec3f(0.0f), {0.5f, 0.9f, 0.4f}), glass, turner);
  look_into_ball_room(scene);
  return scene;
}

Scene glossy_things() {
  Scene scene = empty_scene("gloss");
  Room room = painted_room(scene);
  room.floor = add_material(scene, glossy({0.45f, 0.4f, 0.35f}, 0.3f));
  add_room(scene, room);
  add_ceiling_lamp(scene);
  const int table = add_node(scene, -1, {0.0f, 0.0f, -0.1f});
  turn(scene, table, kUp, [](float frame) { return radians(7.0f) * frame; });
  const auto put = [&](int index, const MetallicRoughness& surface, bool is_box) {
    const float angle = radians(60.0f) * static_cast<float>(index);
    const int node = add_node(scene, table, {0.7f * std::cos(angle), 0.28f, 0.7f * std::sin(angle)});
    show(scene, is_box ? box_mesh(Vec3f(0.0f), {0.4f, 0.55f, 0.4f}) : ball(0.28f), add_material(scene, surface), node);
  };
  put(0, metal({0.9f, 0.7f, 0.35f}, 0.15f), false);
  put(1, glossy({0.7f, 0.1f, 0.1f}, 0.15f), true);
  put(2, metal({0.8f, 0.8f, 0.85f}, 0.3f), true);
  put(3, glossy({0.1f, 0.25f, 0.6f}, 0.3f), false);
  put(4, metal({0.85f, 0.5f, 0.4f}, 0.5f), false);
  put(5, glossy({0.2f, 0.5f, 0.2f}, 0.5f), true);
  look_at(scene, {0.0f, 0.4f, 0.0f}, radians(4.0f), radians(22.0f), 1.6f, 3.6f);
  return scene;
}

}  // namespace lippmann::bench
