// Builds one of the built-in scenes: nodes, materials, seamless animations, lights, the display and its camera.
#pragma once

#include <string>
#include <utility>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

/// Frame rate and number of frames. The scenes are loops: the first frame follows the last.
inline constexpr double kFramesPerSecond = 30.0;
inline constexpr int kFrameCount = 480;
inline constexpr double kLoopSeconds = kFrameCount / kFramesPerSecond;

inline constexpr Vec3f kUp(0.0f, 1.0f, 0.0f);

/// at() returns a transform without rotation. turned() returns a transform that rotates by `angle` radians about an axis.
Transform at(Vec3f translation, float scale = 1.0f);
Transform turned(Vec3f translation, Vec3f unit_axis, float angle, float scale = 1.0f);

/// Materials of different gloss. To add a texture, set `texture`; it is multiplied by `color`.
PhongSurface matte(Vec3f color);
PhongSurface glossy(Vec3f color, float highlight, float highlight_size, float mirror = 0.0f);
PhongSurface polished_metal(Vec3f color, float mirror);

/// A sinusoidal oscillation: amplitude * sin(2 pi (cycles * t / loop duration + phase)).
struct Swing {
  float amplitude = 0.0f;  ///< in radians for swing(), in units of length for bob()
  int cycles = 1;          ///< cycles per loop; a whole number, so that the loop is seamless
  float phase = 0.0f;      ///< phase at the start of the loop, as a fraction of a cycle (0 ... 1)
};

class SceneBuilder {
 public:
  explicit SceneBuilder(std::string name);

  int add_node(std::string name, int parent, const Transform& local = {});
  int add_shape(Shape shape);
  int add_texture(Texture texture);
  int add_material(std::string name, const PhongSurface& surface);
  /// Adds an instance of an existing shape or of a new one.
  void show(std::string name, int shape, int material, int node);
  void show(std::string name, Shape shape, int material, int node) {
    show(std::move(name), add_shape(std::move(shape)), material, node);
  }

  /// Rotates the node at a constant speed about an axis of its own frame, in addition to its initial rotation. `turns` is the
  /// number of turns per loop. Negative turns are clockwise, seen from the tip of the axis. `start` is the initial angle in
  /// turns.
  void spin(int node, Vec3f unit_axis, int turns, float start = 0.0f);
  /// Rotates the node back and forth about an axis of its own frame, around its initial rotation.
  void swing(int node, Vec3f unit_axis, const Swing& swing);
  /// Moves the node back and forth along a direction of its parent's frame, around its initial position.
  void bob(int node, Vec3f unit_direction, const Swing& swing);

  void add_light(std::string name, Vec3f position, Vec3f color);
  void set_background(Vec3f horizon, Vec3f zenith) { scene_.background = {horizon, zenith, {0.0f, 1.0f, 0.0f}}; }
  void set_max_depth(int vertices) { scene_.max_depth = vertices; }

  /// Adds a painted backdrop far behind the array and parallel to it. Its colour is `glow` in the middle and `edge` at the
  /// border. Call set_display() first.
  void add_backdrop(Vec3f glow, Vec3f edge);

  /// Places the array at `center`, and adds a camera at the viewer whose picture covers the array. The array faces +z before it
  /// is turned by `yaw` to the right and by `pitch` upwards, in radians. The viewer is at `viewing_distance` in front of it.
  /// Returns the array's node.
  int set_display(Vec3f center, float yaw, float pitch, float plane_height, float viewing_distance);

  Scene take() { return std::move(scene_); }

 private:
  NodeAnimation& animation_of(int node);
  Scene scene_;
};

}  // namespace lippmann::builtin
