// Builds a Scene step by step: nodes, materials, seamless animations, lights, the display and its camera.
#pragma once

#include <string>
#include <utility>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

/// Frame rate and length of the built-in scenes, which are loops: the last frame is followed by the first.
inline constexpr double kFramesPerSecond = 30.0;
inline constexpr int kFrameCount = 480;
inline constexpr double kLoopSeconds = kFrameCount / kFramesPerSecond;

inline constexpr Vec3f kUp(0.0f, 1.0f, 0.0f);

/// Return a transform without rotation, and one that rotates about an axis.
Transform at(Vec3f translation, float scale = 1.0f);
Transform turned(Vec3f translation, Vec3f unit_axis, float angle, float scale = 1.0f);

/// Materials that differ only in polish. To texture one, set `texture`; the colour then tints it.
PhongSurface matte(Vec3f color);
PhongSurface glossy(Vec3f color, float highlight, float highlight_size, float mirror = 0.0f);
PhongSurface polished_metal(Vec3f color, float mirror);

/// An oscillation: amplitude sin(2 pi (cycles t / loop + phase)).
struct Swing {
  float amplitude = 0.0f;  ///< radians, or units of length
  int cycles = 1;          ///< whole number, so that the loop closes
  float phase = 0.0f;      ///< 0 ... 1
};

class SceneBuilder {
 public:
  explicit SceneBuilder(std::string name);

  int add_node(std::string name, int parent, const Transform& local = {});
  int add_shape(Shape shape);
  int add_texture(Texture texture);
  int add_material(std::string name, const PhongSurface& surface);
  /// Shows an existing or a new shape.
  void show(std::string name, int shape, int material, int node);
  void show(std::string name, Shape shape, int material, int node) {
    show(std::move(name), add_shape(std::move(shape)), material, node);
  }

  /// Rotates the node uniformly about an axis of its own frame by `turns` whole turns per loop (negative: clockwise), in
  /// addition to its rest rotation. `start`: initial angle in turns.
  void spin(int node, Vec3f unit_axis, int turns, float start = 0.0f);
  /// Swings the node about an axis of its own frame, around its rest rotation.
  void swing(int node, Vec3f unit_axis, const Swing& swing);
  /// Moves the node back and forth along a direction of its parent's frame, around its rest position.
  void bob(int node, Vec3f unit_direction, const Swing& swing);

  void add_light(std::string name, Vec3f position, Vec3f color);
  void set_background(Vec3f horizon, Vec3f zenith) { scene_.background = {horizon, zenith, {0.0f, 1.0f, 0.0f}}; }
  void set_max_depth(int vertices) { scene_.max_depth = vertices; }

  /// Adds a painted backdrop far behind the array, parallel to it: `glow` in its middle, `edge` around. Call after
  /// set_display().
  void add_backdrop(Vec3f glow, Vec3f edge);

  /// Places the array at `center`, seen from `yaw` (right) and `pitch` (above) at `viewing_distance`, and a camera there whose
  /// picture covers the array. Returns the array's node.
  int set_display(Vec3f center, float yaw, float pitch, float plane_height, float viewing_distance);

  Scene take() { return std::move(scene_); }

 private:
  NodeAnimation& animation_of(int node);
  Scene scene_;
};

}  // namespace lippmann::builtin
