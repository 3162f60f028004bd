#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::bench {

inline constexpr int kHostileFrames = 16;
inline constexpr double kHostileFramesPerSecond = 25.0;
inline constexpr Vec3f kUp(0.0f, 1.0f, 0.0f);

Scene empty_scene(const std::string& name);

MetallicRoughness matte(Vec3f color);
MetallicRoughness glossy(Vec3f color, float roughness);
MetallicRoughness metal(Vec3f color, float roughness);
MetallicRoughness clear_glass();
MetallicRoughness glowing(Vec3f radiance);

int add_material(Scene& scene, const MetallicRoughness& surface);
int add_textured(Scene& scene, MetallicRoughness surface, Texture texture);

Texture checker(Vec3f light, Vec3f dark);
Texture grain(Vec3f color, std::uint32_t seed);

Mesh box_mesh(Vec3f center, Vec3f size);

int add_node(Scene& scene, int parent, Vec3f place = Vec3f(0.0f));
void show(Scene& scene, Shape shape, int material, int node = -1);

/// The floor is the plane y = 0. Its texture repeats every `tile` metres.
void add_floor(Scene& scene, float half_size, int material, float tile = 1.0f);

/// Up to six walls, seen from inside. The floor is at y = 0, and the wall behind the viewer at z = front. A material of -1
/// leaves out the wall.
struct Room {
  float half_width = 1.6f, height = 2.0f, back = -1.5f, front = 4.0f;
  int floor = -1, ceiling = -1, left = -1, right = -1, rear = -1, viewer_end = -1;
  float tile = 1.0f;
};
void add_room(Scene& scene, const Room& room);
Room painted_room(Scene& scene);

/// Adds a square lamp that shines downwards. A cover blocks its upper side, because faces emit light on both sides.
void add_lamp(Scene& scene, Vec3f center, float half_size, Vec3f radiance, int node = -1);
void add_ball_lamp(Scene& scene, float radius, Vec3f radiance, int node);
void add_point_light(Scene& scene, Vec3f color, int node);

// Animate a node. `of_frame` returns the translation or angle of the node at frames 0 to kHostileFrames - 1.

void move(Scene& scene, int node, const std::function<Vec3f(float frame)>& of_frame,
          Interpolation interpolation = Interpolation::kLinear);
/// of_frame() returns the angle in radians, which must change by less than half a turn per frame.
void turn(Scene& scene, int node, Vec3f axis, const std::function<float(float frame)>& of_frame);

/// Adds a lens array, seen from `yaw` radians to the right and `pitch` radians above. Returns its node.
int look_at(Scene& scene, Vec3f center, float yaw, float pitch, float height, float distance);

Scene scaled(Scene scene, float factor);

}  // namespace lippmann::bench
