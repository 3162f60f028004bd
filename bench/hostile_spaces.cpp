#include <cmath>

#include "bench/hostile_builders.hpp"
#include "bench/hostile_parts.hpp"
#include "scene/builtin/meshes.hpp"

namespace lippmann::bench {
namespace {

constexpr Vec3f kRight(1.0f, 0.0f, 0.0f);

Mesh segmented_box(float width, float height, int segments) {
  Mesh mesh;
  const float w = 0.5f * width, h = 0.5f * height / static_cast<float>(segments);
  for (int s = 0; s < segments; ++s) {
    const float y = h * static_cast<float>(2 * s + 1);
    builtin::append(mesh, builtin::rectangle({0.0f, y, w}, {w, 0.0f, 0.0f}, {0.0f, h, 0.0f}));
    builtin::append(mesh, builtin::rectangle({0.0f, y, -w}, {-w, 0.0f, 0.0f}, {0.0f, h, 0.0f}));
    builtin::append(mesh, builtin::rectangle({w, y, 0.0f}, {0.0f, 0.0f, -w}, {0.0f, h, 0.0f}));
    builtin::append(mesh, builtin::rectangle({-w, y, 0.0f}, {0.0f, 0.0f, w}, {0.0f, h, 0.0f}));
  }
  builtin::append(mesh, builtin::rectangle({0.0f, height, 0.0f}, {w, 0.0f, 0.0f}, {0.0f, 0.0f, -w}));
  return mesh;
}

void bind_to_joints(Mesh& mesh, float height, int joints) {
  mesh.skin.per_vertex = 2;
  for (const Vec3f& p : mesh.positions) {
    const float place = p.y / height * static_cast<float>(joints - 1);
    const int lower = std::min(static_cast<int>(place), joints - 2);
    const float share = place - static_cast<float>(lower);
    mesh.skin.joints.insert(mesh.skin.joints.end(), {static_cast<std::uint32_t>(lower), static_cast<std::uint32_t>(lower + 1)});
    mesh.skin.weights.insert(mesh.skin.weights.end(), {1.0f - share, share});
  }
}

void add_furniture(Scene& scene, int wood, int cloth) {
  show(scene, box_mesh({-0.7f, 0.42f, -0.5f}, {0.9f, 0.06f, 0.6f}), wood);
  for (const float x : {-1.1f, -0.3f})
    for (const float z : {-0.75f, -0.25f}) show(scene, box_mesh({x, 0.2f, z}, {0.06f, 0.4f, 0.06f}), wood);
  show(scene, box_mesh({0.65f, 0.22f, -1.1f}, {1.0f, 0.44f, 0.6f}), cloth);
  show(scene, box_mesh({0.65f, 0.6f, -1.35f}, {1.0f, 0.4f, 0.15f}), cloth);
  for (const float y : {0.9f, 1.2f, 1.5f}) show(scene, box_mesh({-0.9f, y, -1.38f}, {0.9f, 0.04f, 0.24f}), wood);
}

void add_aimed_light(Scene& scene, LightKind kind, Vec3f from, Vec3f to, Vec3f color) {
  Light light;
  light.kind = kind;
  light.node = add_node(scene, -1, from);
  scene.nodes.back().local.rotation = glm::quatLookAt(glm::normalize(to - from), kUp);
  light.color = color;
  light.inverse_square = kind != LightKind::kDirectional;
  light.inner_cone = radians(15.0f), light.outer_cone = radians(30.0f);
  scene.lights.push_back(std::move(light));
}

}  // namespace

Scene flight_through_room() {
  Scene scene = empty_scene("flight");
  Room room = painted_room(scene);
  room.back = -4.0f;
  add_room(scene, room);
  for (const float z : {1.5f, -1.0f, -3.0f}) add_lamp(scene, {0.0f, 1.98f, z}, 0.25f, Vec3f(9.0f, 8.5f, 7.5f));
  const Vec3f colors[] = {{0.7f, 0.4f, 0.2f}, {0.2f, 0.4f, 0.7f}, {0.7f, 0.65f, 0.2f}};
  for (int i = 0; i < 6; ++i) {
    const float side = i % 2 == 0 ? -1.0f : 1.0f, step = static_cast<float>(i),
                height = 0.5f + 0.2f * static_cast<float>(i % 3);
    show(scene, box_mesh({side * (0.75f + 0.1f * step), 0.5f * height, 0.6f - 0.7f * step}, {0.4f, height, 0.4f}),
         add_material(scene, matte(colors[i % 3])));
  }
  const int display = look_at(scene, Vec3f(0.0f), 0.0f, 0.0f, 1.4f, 2.2f);
  move(scene, display, [](float frame) { return Vec3f(0.02f * frame, 0.85f, 0.6f - 0.09f * frame); });
  turn(scene, display, kUp, [](float frame) { return radians(1.2f) * (frame - 6.0f); });
  return scene;
}

Scene walker() {
  constexpr int kJoints = 4;
  constexpr float kHeight = 1.2f;
  Scene scene = empty_scene("walker");
  add_floor(scene, 8.0f, add_textured(scene, matte(Vec3f(1.0f)), checker({0.65f, 0.6f, 0.5f}, {0.3f, 0.32f, 0.35f})), 0.5f);
  scene.background = {{0.45f, 0.5f, 0.55f}, {0.2f, 0.35f, 0.6f}};
  add_lamp(scene, {-0.8f, 2.2f, 0.6f}, 0.25f, Vec3f(28.0f, 26.0f, 22.0f));
  Skin skin;
  int parent = add_node(scene, -1);
  move(scene, parent, [](float frame) { return Vec3f(-0.4f + 0.06f * frame, 0.0f, 0.0f); });
  for (int joint = 0; joint < kJoints; ++joint) {
    const float step = kHeight / (kJoints - 1), y = joint > 0 ? step : 0.0f, phase = 0.5f * static_cast<float>(joint);
    parent = add_node(scene, parent, {0.0f, y, 0.0f});
    if (joint > 0) turn(scene, parent, {0.0f, 0.0f, 1.0f}, [=](float frame) { return 0.35f * std::sin(0.6f * frame + phase); });
    skin.joints.push_back(parent);
    skin.joint_from_mesh.push_back({Mat3f(1.0f), {0.0f, -step * static_cast<float>(joint), 0.0f}});
  }
  scene.skins.push_back(std::move(skin));
  Mesh body = segmented_box(0.28f, kHeight, 18);
  bind_to_joints(body, kHeight, kJoints);
  show(scene, std::move(body), add_material(scene, matte({0.75f, 0.35f, 0.15f})));
  scene.instances.back().skin = 0;
  look_at(scene, {0.0f, 0.55f, 0.0f}, radians(12.0f), radians(24.0f), 1.7f, 4.0f);
  return scene;
}

Scene furnished_room() {
  Scene scene = empty_scene("furnished");
  Room room = painted_room(scene);
  room.left = room.ceiling;
  room.right = -1;
  room.floor = add_material(scene, matte({0.5f, 0.35f, 0.2f}));
  add_room(scene, room);
  const int wood = add_material(scene, glossy({0.4f, 0.22f, 0.1f}, 0.5f)),
            cloth = add_material(scene, matte({0.15f, 0.3f, 0.5f}));
  add_furniture(scene, wood, cloth);
  add_aimed_light(scene, LightKind::kDirectional, {3.0f, 3.0f, 0.6f}, {0.0f, 0.4f, 0.0f}, Vec3f(7.0f, 6.4f, 5.5f));
  add_aimed_light(scene, LightKind::kSpot, {-0.7f, 1.7f, -0.3f}, {-0.7f, 0.4f, -0.5f}, Vec3f(2.0f, 1.8f, 1.4f));
  scene.background = {{0.25f, 0.3f, 0.4f}, {0.2f, 0.3f, 0.5f}};
  const int door = add_node(scene, -1);
  move(scene, door, [](float frame) { return Vec3f(0.0f, 0.0f, 0.07f * frame); });
  show(scene, box_mesh({1.62f, 1.0f, -0.9f}, {0.04f, 2.0f, 1.0f}), wood, door);
  const int cart = add_node(scene, -1);
  move(scene, cart, [](float frame) { return kRight * (0.9f - 0.05f * frame) + Vec3f(0.0f, 0.2f, 0.35f); });
  show(scene, box_mesh(Vec3f(0.0f), {0.4f, 0.4f, 0.3f}), cloth, cart);
  look_at(scene, {0.0f, 1.05f, -0.2f}, 0.0f, radians(-3.0f), 2.2f, 3.6f);
  return scene;
}

Scene turntable() {
  Scene scene = empty_scene("turntable");
  add_room(scene, painted_room(scene));
  add_lamp(scene, {0.0f, 1.98f, 0.0f}, 0.25f, Vec3f(9.0f, 8.5f, 7.5f));
  add_point_light(scene, Vec3f(1.5f), add_node(scene, -1, {0.9f, 1.6f, 1.5f}));
  const int table = add_node(scene, -1);
  turn(scene, table, kUp, [](float frame) { return radians(4.0f) * frame; });
  const int blue = add_material(scene, glossy({0.2f, 0.4f, 0.7f}, 0.4f)),
            brown = add_material(scene, matte({0.7f, 0.4f, 0.2f}));
  show(scene, box_mesh({0.0f, 0.05f, 0.0f}, {0.8f, 0.1f, 0.8f}), brown, table);
  show(scene, box_mesh({-0.15f, 0.45f, 0.0f}, {0.3f, 0.7f, 0.3f}), blue, table);
  show(scene, box_mesh({0.2f, 0.25f, 0.1f}, {0.2f, 0.3f, 0.2f}), brown, table);
  look_at(scene, {0.0f, 0.7f, 0.0f}, 0.0f, radians(8.0f), 1.6f, 3.6f);
  return scene;
}

}  // namespace lippmann::bench
