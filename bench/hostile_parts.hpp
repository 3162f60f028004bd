// What the hostile scenes are put together from: nodes, materials, rooms, lamps, motions from frame to frame, and the view.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::bench {

inline constexpr int kHostileFrames = 16;
inline constexpr double kHostileFramesPerSecond = 25.0;
inline constexpr Vec3f kUp(0.0f, 1.0f, 0.0f);

/// Without anything in it.
Scene empty_scene(const std::string& name);

// ---- Materials. Each returns its index. ---------------------------------------------------------------------------------

MetallicRoughness matte(Vec3f color);
MetallicRoughness glossy(Vec3f color, float roughness);
MetallicRoughness metal(Vec3f color, float roughness);
MetallicRoughness clear_glass();
MetallicRoughness glowing(Vec3f radiance);

int add_material(Scene& scene, const MetallicRoughness& surface);
int add_textured(Scene& scene, MetallicRoughness surface, Texture texture);

/// A checkerboard of two by two squares.
Texture checker(Vec3f light, Vec3f dark);
/// Grain of every size down to a texel.
Texture grain(Vec3f color, std::uint32_t seed);

// ---- Shapes -------------------------------------------------------------------------------------------------------------

Mesh box_mesh(Vec3f center, Vec3f size);

int add_node(Scene& scene, int parent, Vec3f place = Vec3f(0.0f));
void show(Scene& scene, Shape shape, int material, int node = -1);

/// A floor in y = 0 around the origin; its texture repeats every `tile`.
void add_floor(Scene& scene, float half_size, int material, float tile = 1.0f);

/// Six walls seen from inside: floor y = 0, ceiling y = height, the viewer's end at z = front. Materials: of which -1 leaves
/// the wall out.
struct Room {
  float half_width = 1.6f, height = 2.0f, back = -1.5f, front = 4.0f;
  int floor = -1, ceiling = -1, left = -1, right = -1, rear = -1, viewer_end = -1;
  float tile = 1.0f;  ///< textures repeat every so many metres
};
void add_room(Scene& scene, const Room& room);
/// All walls light but for a red one on the left and a green one on the right.
Room painted_room(Scene& scene);

/// A square of that half size that shines downwards: its back, as faces shine on both sides, is covered.
void add_lamp(Scene& scene, Vec3f center, float half_size, Vec3f radiance, int node = -1);
/// A ball that shines.
void add_ball_lamp(Scene& scene, float radius, Vec3f radiance, int node);
/// Falls off with the square of distance; shines from the node.
void add_point_light(Scene& scene, Vec3f color, int node);

// ---- Motion. `of_frame` gives the value at frames 0 to kHostileFrames - 1. -------------------------------------------------

void move(Scene& scene, int node, const std::function<Vec3f(float frame)>& of_frame,
          Interpolation interpolation = Interpolation::kLinear);
/// Radians about a unit axis, less than half a turn from frame to frame.
void turn(Scene& scene, int node, Vec3f axis, const std::function<float(float frame)>& of_frame);

// ---- The view -----------------------------------------------------------------------------------------------------------

/// An array of that height around `center`, seen from `yaw` to the right and `pitch` from above. Returns its node.
int look_at(Scene& scene, Vec3f center, float yaw, float pitch, float height, float distance);

/// All lengths times `factor`, of scenes without lights that fall off with distance: the picture stays the same.
Scene scaled(Scene scene, float factor);

}  // namespace lippmann::bench
