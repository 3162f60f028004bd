#include <array>
#include <cmath>

#include "bench/hostile_builders.hpp"
#include "bench/hostile_parts.hpp"

namespace lippmann::bench {
namespace {

void add_post(Scene& scene) {
  show(scene, box_mesh({0.0f, 0.6f, -0.4f}, {0.2f, 1.2f, 0.2f}), add_material(scene, matte({0.3f, 0.4f, 0.7f})));
}

void look_into_lamp_room(Scene& scene) { look_at(scene, {0.0f, 0.95f, -0.2f}, 0.0f, radians(8.0f), 2.1f, 3.6f); }

Vec3f place_on_flight(float frame) {
  const float angle = radians(22.5f) * frame + 0.4f;
  return {0.9f * std::cos(angle), 0.9f + 0.25f * std::sin(2.0f * angle), -0.4f + 0.75f * std::sin(angle)};
}

}  // namespace

Scene fast_lamp() {
  Scene scene = empty_scene("fast-lamp");
  add_room(scene, painted_room(scene));
  add_post(scene);
  const int lamp = add_node(scene, -1);
  move(scene, lamp, place_on_flight);
  add_ball_lamp(scene, 0.1f, Vec3f(38.0f, 35.0f, 28.0f), lamp);
  look_into_lamp_room(scene);
  return scene;
}

Scene fast_point_light() {
  Scene scene = empty_scene("fast-point");
  add_room(scene, painted_room(scene));
  add_post(scene);
  const int light = add_node(scene, -1);
  move(scene, light, place_on_flight);
  add_point_light(scene, Vec3f(1.3f, 1.2f, 1.0f), light);
  look_into_lamp_room(scene);
  return scene;
}

Scene tiny_lamp() {
  Scene scene = empty_scene("tiny-lamp");
  add_room(scene, painted_room(scene));
  add_post(scene);
  show(scene, box_mesh({0.3f, 1.5f, 0.2f}, Vec3f(0.008f)), add_material(scene, glowing(Vec3f(16000.0f, 15000.0f, 12000.0f))));
  const int box = add_node(scene, -1, {-0.75f, 0.25f, -0.1f});
  turn(scene, box, kUp, [](float frame) { return radians(8.0f) * frame; });
  show(scene, box_mesh(Vec3f(0.0f), {0.6f, 0.5f, 0.3f}), add_material(scene, matte({0.7f, 0.6f, 0.2f})), box);
  look_into_lamp_room(scene);
  return scene;
}

Scene flashing_lamps() {
  constexpr std::array<bool, kHostileFrames> kOn{true, true,  true,  false, false, true, false, true,
                                                 true, false, false, false, true,  true, false, true};
  constexpr Vec3f kAway(0.0f, 1.0f, 0.0f);
  Scene scene = empty_scene("flash");
  add_room(scene, painted_room(scene));
  add_post(scene);
  const int lamp = add_node(scene, -1);
  move(
      scene, lamp, [&](float frame) { return kOn[static_cast<std::size_t>(frame)] ? Vec3f(0.0f) : kAway; },
      Interpolation::kStep);
  add_lamp(scene, {0.4f, 1.95f, -0.2f}, 0.25f, Vec3f(14.0f, 13.0f, 11.0f), lamp);
  const int ball = add_node(scene, -1);
  move(scene, ball, [](float frame) { return Vec3f(-1.2f + 0.15f * frame, 0.35f, 0.1f); });
  add_ball_lamp(scene, 0.12f, Vec3f(5.0f, 8.0f, 14.0f), ball);
  look_into_lamp_room(scene);
  return scene;
}

}  // namespace lippmann::bench
