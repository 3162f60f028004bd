#include "bench/hostile_parts.hpp"

#include <cmath>
#include <utility>

#include "scene/builtin/meshes.hpp"
#include "scene/builtin/textures.hpp"

namespace lippmann::bench {
namespace {

using builtin::rectangle;

template <class T>
Channel<T> keys_of(const std::function<T(float)>& of_frame, Interpolation interpolation) {
  Channel<T> channel;
  channel.interpolation = interpolation;
  for (int frame = 0; frame < kHostileFrames; ++frame) {
    channel.times.push_back(frame / kHostileFramesPerSecond);
    channel.values.push_back(of_frame(static_cast<float>(frame)));
  }
  return channel;
}

NodeAnimation& animation_of(Scene& scene, int node) {
  for (NodeAnimation& animation : scene.timeline.animations)
    if (animation.node == node) return animation;
  scene.timeline.animations.emplace_back().node = node;
  return scene.timeline.animations.back();
}

void scale_lengths(std::vector<Vec3f>& points, float factor) {
  for (Vec3f& point : points) point *= factor;
}

}  // namespace

Scene empty_scene(const std::string& name) {
  Scene scene;
  scene.name = name;
  scene.timeline.frames_per_second = kHostileFramesPerSecond;
  scene.timeline.frame_count = kHostileFrames;
  return scene;
}

MetallicRoughness matte(Vec3f color) { return glossy(color, 1.0f); }

MetallicRoughness glossy(Vec3f color, float roughness) {
  MetallicRoughness surface;
  surface.base_color = Vec4f(color, 1.0f);
  surface.metallic = 0.0f;
  surface.roughness = roughness;
  return surface;
}

MetallicRoughness metal(Vec3f color, float roughness) {
  MetallicRoughness surface = glossy(color, roughness);
  surface.metallic = 1.0f;
  return surface;
}

MetallicRoughness clear_glass() {
  MetallicRoughness surface = glossy(Vec3f(1.0f), 0.0f);
  surface.transmission = 1.0f;
  return surface;
}

MetallicRoughness glowing(Vec3f radiance) {
  MetallicRoughness surface = matte(Vec3f(0.0f));
  surface.emissive = radiance;
  return surface;
}

int add_material(Scene& scene, const MetallicRoughness& surface) {
  scene.materials.push_back({"", surface});
  return static_cast<int>(scene.materials.size()) - 1;
}

int add_textured(Scene& scene, MetallicRoughness surface, Texture texture) {
  scene.textures.push_back(std::move(texture));
  surface.base_color_map.texture = static_cast<int>(scene.textures.size()) - 1;
  return add_material(scene, surface);
}

Texture checker(Vec3f light, Vec3f dark) {
  return builtin::paint("checker", 64, 64, [=](Vec2f uv) { return (uv.x < 0.5f) == (uv.y < 0.5f) ? light : dark; });
}

Texture grain(Vec3f color, std::uint32_t seed) {
  return builtin::paint("grain", 256, 256, [=](Vec2f uv) {
    return color * (1.0f + 0.9f * builtin::fractal_noise(16.0f * uv, {16, 16}, 4, seed));
  });
}

Mesh box_mesh(Vec3f center, Vec3f size) {
  const Vec3f half = 0.5f * size;
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      Vec3f out(0.0f), u(0.0f), v(0.0f);
      const int next = (axis + 1) % 3, last = (axis + 2) % 3;
      out[axis] = side * half[axis];
      u[next] = side * half[next], v[last] = half[last];
      builtin::append(mesh, rectangle(center + out, u, v));
    }
  return mesh;
}

int add_node(Scene& scene, int parent, Vec3f place) {
  Node node;
  node.parent = parent;
  node.local.translation = place;
  scene.nodes.push_back(std::move(node));
  return static_cast<int>(scene.nodes.size()) - 1;
}

void show(Scene& scene, Shape shape, int material, int node) {
  scene.shapes.push_back(std::move(shape));
  scene.instances.push_back({"", static_cast<int>(scene.shapes.size()) - 1, material, node});
}

void add_floor(Scene& scene, float half_size, int material, float tile) {
  show(scene, rectangle(Vec3f(0.0f), {half_size, 0.0f, 0.0f}, {0.0f, 0.0f, -half_size}, Vec2f(2.0f * half_size / tile)),
       material);
}

void add_room(Scene& scene, const Room& room) {
  const float w = room.half_width, h = 0.5f * room.height, d = 0.5f * (room.front - room.back);
  const float middle = 0.5f * (room.front + room.back);
  const auto wall = [&](int material, Vec3f center, Vec3f u, Vec3f v) {
    const Vec2f repeats = 2.0f / room.tile * Vec2f(glm::length(u), glm::length(v));
    if (material >= 0) show(scene, rectangle(center, u, v, repeats), material);
  };
  wall(room.floor, {0.0f, 0.0f, middle}, {w, 0.0f, 0.0f}, {0.0f, 0.0f, -d});
  wall(room.ceiling, {0.0f, room.height, middle}, {w, 0.0f, 0.0f}, {0.0f, 0.0f, d});
  wall(room.left, {-w, h, middle}, {0.0f, 0.0f, -d}, {0.0f, h, 0.0f});
  wall(room.right, {w, h, middle}, {0.0f, 0.0f, d}, {0.0f, h, 0.0f});
  wall(room.rear, {0.0f, h, room.back}, {w, 0.0f, 0.0f}, {0.0f, h, 0.0f});
  wall(room.viewer_end, {0.0f, h, room.front}, {-w, 0.0f, 0.0f}, {0.0f, h, 0.0f});
}

Room painted_room(Scene& scene) {
  const int white = add_material(scene, matte(Vec3f(0.72f)));
  Room room;
  room.floor = add_material(scene, matte({0.6f, 0.55f, 0.48f}));
  room.ceiling = room.rear = room.viewer_end = white;
  room.left = add_material(scene, matte({0.65f, 0.15f, 0.1f}));
  room.right = add_material(scene, matte({0.15f, 0.5f, 0.15f}));
  return room;
}

void add_lamp(Scene& scene, Vec3f center, float half_size, Vec3f radiance, int node) {
  const auto square = [](Vec3f middle, float half) { return rectangle(middle, {half, 0.0f, 0.0f}, {0.0f, 0.0f, half}); };
  show(scene, square(center, half_size), add_material(scene, glowing(radiance)), node);
  MetallicRoughness black = matte(Vec3f(0.0f));
  black.specular = 0.0f;
  show(scene, square(center + Vec3f(0.0f, 0.005f, 0.0f), 1.03f * half_size), add_material(scene, black), node);
}

void add_ball_lamp(Scene& scene, float radius, Vec3f radiance, int node) {
  show(scene, builtin::uv_sphere(radius, 16, 8), add_material(scene, glowing(radiance)), node);
}

void add_point_light(Scene& scene, Vec3f color, int node) {
  Light light;
  light.node = node;
  light.color = color;
  light.inverse_square = true;
  scene.lights.push_back(std::move(light));
}

void move(Scene& scene, int node, const std::function<Vec3f(float frame)>& of_frame, Interpolation interpolation) {
  animation_of(scene, node).translation = keys_of(of_frame, interpolation);
}

void turn(Scene& scene, int node, Vec3f axis, const std::function<float(float frame)>& of_frame) {
  const std::function<Quatf(float)> rotation = [&](float frame) { return glm::angleAxis(of_frame(frame), axis); };
  animation_of(scene, node).rotation = keys_of(rotation, Interpolation::kLinear);
}

int look_at(Scene& scene, Vec3f center, float yaw, float pitch, float height, float distance) {
  const int display = add_node(scene, -1, center);
  scene.nodes.back().local.rotation = glm::angleAxis(yaw, kUp) * glm::angleAxis(-pitch, Vec3f(1.0f, 0.0f, 0.0f));
  scene.display = DisplayPlacement{display, height, distance};
  return display;
}

Scene scaled(Scene scene, float factor) {
  for (Shape& shape : scene.shapes) scale_lengths(std::get<Mesh>(shape).positions, factor);
  for (Node& node : scene.nodes) node.local.translation *= factor;
  for (NodeAnimation& animation : scene.timeline.animations) scale_lengths(animation.translation.values, factor);
  scene.display->plane_height *= factor;
  scene.display->viewing_distance *= factor;
  return scene;
}

}  // namespace lippmann::bench
