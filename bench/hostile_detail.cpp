#include <cmath>
#include <vector>

#include "bench/hostile_builders.hpp"
#include "bench/hostile_parts.hpp"
#include "scene/builtin/meshes.hpp"

namespace lippmann::bench {
namespace {

constexpr float kViewHeight = 1.8f;
constexpr float kPixel = kViewHeight / 120.0f;  ///< size of a pixel in the plane of the array

void look_into_detailed_room(Scene& scene) { look_at(scene, {0.0f, 0.9f, 0.0f}, 0.0f, radians(6.0f), kViewHeight, 3.6f); }

Mesh rod(Vec3f from, Vec3f to, float pixels) {
  const float radius = 0.5f * pixels * kPixel;
  return builtin::tube({from, to}, {radius, radius}, 6, false);
}

Mesh fence(float left, float right, float pixels) {
  constexpr int kRods = 16;
  Mesh mesh;
  for (int i = 0; i < kRods; ++i) {
    const float x = left + (right - left) * static_cast<float>(i) / (kRods - 1);
    builtin::append(mesh, rod({x, 0.0f, 0.0f}, {x + 0.05f, 1.4f, 0.0f}, pixels));
  }
  return mesh;
}

Mesh grid(float size, int lines, float pixels) {
  Mesh mesh;
  for (int i = 0; i <= lines; ++i) {
    const float at = size * (static_cast<float>(i) / static_cast<float>(lines) - 0.5f);
    builtin::append(mesh, rod({at, -0.5f * size, 0.0f}, {at, 0.5f * size, 0.0f}, pixels));
    builtin::append(mesh, rod({-0.5f * size, at, 0.0f}, {0.5f * size, at, 0.0f}, pixels));
  }
  return mesh;
}

Mesh sagging_wire(float height, float z, float pixels) {
  constexpr int kPieces = 24;
  std::vector<Vec3f> points;
  for (int i = 0; i <= kPieces; ++i) {
    const float x = 2.0f * static_cast<float>(i) / kPieces - 1.0f;
    points.push_back({1.4f * x, height - 0.25f * (1.0f - x * x), z});
  }
  return builtin::tube(points, std::vector<float>(points.size(), 0.5f * pixels * kPixel), 6, false);
}

}  // namespace

Scene thin_things() {
  Scene scene = empty_scene("thin");
  Room room;
  room.floor = add_material(scene, matte({0.55f, 0.5f, 0.45f}));
  room.rear = add_material(scene, matte({0.65f, 0.68f, 0.7f}));
  room.half_width = 3.0f, room.height = 2.4f;
  add_room(scene, room);
  scene.background = {{0.5f, 0.55f, 0.6f}, {0.3f, 0.45f, 0.7f}};
  add_lamp(scene, {0.6f, 2.2f, 0.3f}, 0.25f, Vec3f(16.0f, 14.0f, 11.0f));
  const int dark = add_material(scene, matte(Vec3f(0.08f))), light = add_material(scene, matte(Vec3f(0.8f)));
  const int slider = add_node(scene, -1);
  move(scene, slider, [](float frame) { return Vec3f(0.4f * kPixel * frame, 0.0f, 0.2f); });
  show(scene, fence(-1.0f, -0.15f, 1.0f), dark, slider);
  show(scene, fence(-0.98f, -0.13f, 0.25f), light, slider);
  const int tilted = add_node(scene, -1, {0.5f, 0.75f, 0.1f});
  turn(scene, tilted, glm::normalize(Vec3f(0.3f, 1.0f, 0.4f)), [](float frame) { return 0.5f + radians(1.0f) * frame; });
  show(scene, grid(0.9f, 14, 0.5f), add_material(scene, metal({0.8f, 0.6f, 0.3f}, 0.4f)), tilted);
  const int wires = add_node(scene, -1);
  move(scene, wires, [](float frame) { return Vec3f(0.0f, 0.3f * kPixel * std::sin(0.8f * frame), 0.0f); });
  for (int i = 0; i < 5; ++i) {
    const float step = static_cast<float>(i);
    show(scene, sagging_wire(1.75f - 0.07f * step, 0.3f - 0.2f * step, 0.25f + 0.15f * step), dark, wires);
  }
  look_into_detailed_room(scene);
  return scene;
}

Scene textured_room() {
  constexpr float kSquares = 4.0f * kPixel;
  Scene scene = empty_scene("textured");
  Room room;
  room.floor = add_textured(scene, matte(Vec3f(1.0f)), checker(Vec3f(0.75f), {0.15f, 0.2f, 0.3f}));
  room.rear = room.left = add_textured(scene, matte(Vec3f(1.0f)), checker({0.75f, 0.6f, 0.4f}, {0.3f, 0.1f, 0.08f}));
  MetallicRoughness plaster = matte(Vec3f(1.0f));
  plaster.base_color_map.matrix = glm::mat2(1.0f / 16.0f);
  room.right = room.ceiling = room.viewer_end = add_textured(scene, plaster, grain({0.5f, 0.5f, 0.45f}, 1));
  room.tile = kSquares;
  add_room(scene, room);
  add_lamp(scene, {0.3f, 1.98f, 0.2f}, 0.35f, Vec3f(13.0f, 12.0f, 10.5f));
  MetallicRoughness noisy = matte(Vec3f(1.0f));
  noisy.base_color_map.matrix = glm::mat2(0.5f);
  const int cloth = add_textured(scene, noisy, grain({0.45f, 0.5f, 0.6f}, 2));
  const int turner = add_node(scene, -1, {0.5f, 0.4f, -0.2f});
  turn(scene, turner, kUp, [](float frame) { return radians(5.0f) * frame; });
  show(scene, box_mesh(Vec3f(0.0f), {0.6f, 0.8f, 0.5f}), cloth, turner);
  const int slider = add_node(scene, -1);
  move(scene, slider, [](float frame) { return Vec3f(-1.0f + 0.06f * frame, 0.3f, 0.3f); });
  MetallicRoughness squares = matte(Vec3f(1.0f));
  squares.base_color_map.matrix = glm::mat2(24.0f, 0.0f, 0.0f, 12.0f);
  show(scene, builtin::uv_sphere(0.3f, 48, 24), add_textured(scene, squares, checker({0.8f, 0.75f, 0.2f}, {0.1f, 0.3f, 0.1f})),
       slider);
  look_into_detailed_room(scene);
  return scene;
}

}  // namespace lippmann::bench
