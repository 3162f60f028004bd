// Parts of the scenes that are hard to denoise: nodes, materials, rooms, lamps, motions between frames, and the view.
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

// ---- Materials. Each returns its index. ---------------------------------------------------------------------------------

MetallicRoughness matte(Vec3f color);
MetallicRoughness glossy(Vec3f color, float roughness);
MetallicRoughness metal(Vec3f color, float roughness);
MetallicRoughness clear_glass();
MetallicRoughness glowing(Vec3f radiance);

int add_material(Scene& scene, const MetallicRoughness& surface);
int add_textured(Scene& scene, MetallicRoughness surface, Texture texture);

/// Returns a checkerboard texture of 2 x 2 squares.
Texture checker(Vec3f light, Vec3f dark);
/// Returns a noise texture. It has detail of all sizes down to a texel.
Texture grain(Vec3f color, std::uint32_t seed);

// ---- Shapes -------------------------------------------------------------------------------------------------------------

Mesh box_mesh(Vec3f center, Vec3f size);

int add_node(Scene& scene, int parent, Vec3f place = Vec3f(0.0f));
void show(Scene& scene, Shape shape, int material, int node = -1);

/// Adds a floor in the plane y = 0 around the origin. Its texture repeats every `tile` metres.
void add_floor(Scene& scene, float half_size, int material, float tile = 1.0f);

/// A room of up to six walls, seen from inside. The floor is at y = 0 and the ceiling at y = height. The wall behind the viewer
/// is at z = front. A material of -1 leaves out the wall.
struct Room {
  float half_width = 1.6f, height = 2.0f, back = -1.5f, front = 4.0f;
  int floor = -1, ceiling = -1, left = -1, right = -1, rear = -1, viewer_end = -1;
  float tile = 1.0f;  ///< period of the textures in metres
};
void add_room(Scene& scene, const Room& room);
/// Returns a room with light walls. The left wall is red and the right wall is green.
Room painted_room(Scene& scene);

/// Adds a square lamp that shines downwards. A cover above the lamp blocks its upper side, because faces emit light on both
/// sides.
void add_lamp(Scene& scene, Vec3f center, float half_size, Vec3f radiance, int node = -1);
/// Adds a glowing ball.
void add_ball_lamp(Scene& scene, float radius, Vec3f radiance, int node);
/// Adds a point light at the node. Its light decreases with the squared distance.
void add_point_light(Scene& scene, Vec3f color, int node);

// ---- Motion. `of_frame` returns the value at frames 0 to kHostileFrames - 1. -----------------------------------------------

void move(Scene& scene, int node, const std::function<Vec3f(float frame)>& of_frame,
          Interpolation interpolation = Interpolation::kLinear);
/// Rotates the node about a unit axis. of_frame() returns the angle in radians, which must change by less than half a turn per
/// frame.
void turn(Scene& scene, int node, Vec3f axis, const std::function<float(float frame)>& of_frame);

// ---- The view -----------------------------------------------------------------------------------------------------------

/// Adds a lens array of this height with its centre at `center`. It is seen from `yaw` radians to the right and `pitch` radians
/// above. Returns the node of the array.
int look_at(Scene& scene, Vec3f center, float yaw, float pitch, float height, float distance);

/// Returns the scene with all lengths multiplied by `factor`. The picture stays the same if no light of the scene decreases
/// with distance.
Scene scaled(Scene scene, float factor);

}  // namespace lippmann::bench
