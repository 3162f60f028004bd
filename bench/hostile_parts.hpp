// Building blocks of the hostile scenes: nodes, materials, rooms, lamps, motions between frames, and the view.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::bench {

inline constexpr int kHostileFrames = 16;
inline constexpr double kHostileFramesPerSecond = 25.0;
inline constexpr Vec3f kUp(0.0f, 1.0f, 0.0f);

/// Returns an empty scene.
Scene empty_scene(const std::string& name);

// ---- Materials. Each returns its index. ---------------------------------------------------------------------------------

MetallicRoughness matte(Vec3f color);
MetallicRoughness glossy(Vec3f color, float roughness);
MetallicRoughness metal(Vec3f color, float roughness);
MetallicRoughness clear_glass();
MetallicRoughness glowing(Vec3f radiance);

int add_material(Scene& scene, const MetallicRoughness& surface);
int add_textured(Scene& scene, MetallicRoughness surface, Texture texture);

/// Returns a checkerboard of two by two squares.
Texture checker(Vec3f light, Vec3f dark);
/// Returns noise with detail of every size down to a texel.
Texture grain(Vec3f color, std::uint32_t seed);

// ---- Shapes -------------------------------------------------------------------------------------------------------------

Mesh box_mesh(Vec3f center, Vec3f size);

int add_node(Scene& scene, int parent, Vec3f place = Vec3f(0.0f));
void show(Scene& scene, Shape shape, int material, int node = -1);

/// Adds a floor in y = 0 around the origin; its texture repeats every `tile` metres.
void add_floor(Scene& scene, float half_size, int material, float tile = 1.0f);

/// A room of six walls, seen from inside. The floor is at y = 0, the ceiling at y = height, and the wall at the viewer's end at
/// z = front. A wall with the material -1 is left out.
struct Room {
  float half_width = 1.6f, height = 2.0f, back = -1.5f, front = 4.0f;
  int floor = -1, ceiling = -1, left = -1, right = -1, rear = -1, viewer_end = -1;
  float tile = 1.0f;  ///< period of the textures, in metres
};
void add_room(Scene& scene, const Room& room);
/// Returns a room with light walls, except a red one on the left and a green one on the right.
Room painted_room(Scene& scene);

/// Adds a square lamp that shines downwards. Its back is covered, because faces emit from both sides.
void add_lamp(Scene& scene, Vec3f center, float half_size, Vec3f radiance, int node = -1);
/// Adds a glowing ball.
void add_ball_lamp(Scene& scene, float radius, Vec3f radiance, int node);
/// Adds a point light at the node. Its light falls off with the squared distance.
void add_point_light(Scene& scene, Vec3f color, int node);

// ---- Motion. `of_frame` returns the value at frames 0 to kHostileFrames - 1. -----------------------------------------------

void move(Scene& scene, int node, const std::function<Vec3f(float frame)>& of_frame,
          Interpolation interpolation = Interpolation::kLinear);
/// Rotates about a unit axis, in radians, by less than half a turn per frame.
void turn(Scene& scene, int node, Vec3f axis, const std::function<float(float frame)>& of_frame);

// ---- The view -----------------------------------------------------------------------------------------------------------

/// Adds a lens array of the given height around `center`. It is seen from `yaw` to the right and `pitch` above. Returns the
/// array's node.
int look_at(Scene& scene, Vec3f center, float yaw, float pitch, float height, float distance);

/// Scales all lengths by `factor`. The picture stays the same if no light of the scene falls off with distance.
Scene scaled(Scene scene, float factor);

}  // namespace lippmann::bench
