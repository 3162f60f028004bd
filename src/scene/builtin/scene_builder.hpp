#pragma once

#include <string>
#include <utility>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

inline constexpr double kFramesPerSecond = 30.0;
inline constexpr int kFrameCount = 480;
inline constexpr double kLoopSeconds = kFrameCount / kFramesPerSecond;

inline constexpr Vec3f kUp(0.0f, 1.0f, 0.0f);

/// at() returns a transform without rotation. turned() also rotates by `angle` radians about an axis.
Transform at(Vec3f translation, float scale = 1.0f);
Transform turned(Vec3f translation, Vec3f unit_axis, float angle, float scale = 1.0f);

/// To add a texture, set `texture`; it is multiplied by `color`.
PhongSurface matte(Vec3f color);
PhongSurface glossy(Vec3f color, float highlight, float highlight_size, float mirror = 0.0f);
PhongSurface polished_metal(Vec3f color, float mirror);

struct Swing {
  float amplitude = 0.0f;
  int cycles = 1;
  float phase = 0.0f;  ///< phase at the start of the loop, as a fraction of a cycle
};

class SceneBuilder {
 public:
  explicit SceneBuilder(std::string name);

  int add_node(std::string name, int parent, const Transform& local = {});
  int add_shape(Shape shape);
  int add_texture(Texture texture);
  int add_material(std::string name, const PhongSurface& surface);
  void show(std::string name, int shape, int material, int node);
  void show(std::string name, Shape shape, int material, int node) {
    show(std::move(name), add_shape(std::move(shape)), material, node);
  }

  /// Rotates the node about an axis of its own frame, in addition to its initial rotation. `turns` is the number of turns per
  /// loop, negative for clockwise turns as seen from the tip of the axis. `start` is the initial angle in turns.
  void spin(int node, Vec3f unit_axis, int turns, float start = 0.0f);
  /// Rotates the node back and forth about an axis of its own frame, around its initial rotation.
  void swing(int node, Vec3f unit_axis, const Swing& swing);
  void bob(int node, Vec3f unit_direction, const Swing& swing);

  void add_light(std::string name, Vec3f position, Vec3f color);
  void set_background(Vec3f horizon, Vec3f zenith) { scene_.background = {horizon, zenith, {0.0f, 1.0f, 0.0f}}; }
  void set_max_depth(int vertices) { scene_.max_depth = vertices; }

  /// Adds a backdrop far behind the array and parallel to it. Call set_display() first.
  void add_backdrop(Vec3f glow, Vec3f edge);

  /// Places the array at `center`, and adds a camera at the viewer's position that shows the whole array. The array faces +z
  /// before it is turned by `yaw` to the right and by `pitch` upwards, in radians. Returns the array's node.
  int set_display(Vec3f center, float yaw, float pitch, float plane_height, float viewing_distance);

  Scene take() { return std::move(scene_); }

 private:
  NodeAnimation& animation_of(int node);
  Scene scene_;
};

}  // namespace lippmann::builtin
