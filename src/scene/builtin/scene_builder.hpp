// Puts a Scene together by name and hand: nodes, materials, seamless motions, lights, the display and the camera before it.
#pragma once

#include <string>
#include <utility>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

/// Every built-in scene is a loop: the frame after the last one is the first.
inline constexpr double kFramesPerSecond = 30.0;
inline constexpr int kFrameCount = 480;
inline constexpr double kLoopSeconds = kFrameCount / kFramesPerSecond;

inline constexpr Vec3f kUp(0.0f, 1.0f, 0.0f);

/// One transform without a rotation, and one that turns about an axis.
Transform at(Vec3f translation, float scale = 1.0f);
Transform turned(Vec3f translation, Vec3f unit_axis, float angle, float scale = 1.0f);

/// Surfaces that differ in polish only; textures are added by setting `texture` (the colour then tints it).
PhongSurface matte(Vec3f color);
PhongSurface glossy(Vec3f color, float highlight, float highlight_size, float mirror = 0.0f);
PhongSurface polished_metal(Vec3f color, float mirror);

/// A to-and-fro: amplitude sin(2 pi (cycles t / loop + phase)).
struct Swing {
  float amplitude = 0.0f;  ///< radians, or units of length
  int cycles = 1;          ///< whole, so that the loop closes
  float phase = 0.0f;      ///< 0 ... 1
};

class SceneBuilder {
 public:
  explicit SceneBuilder(std::string name);

  int add_node(std::string name, int parent, const Transform& local = {});
  int add_shape(Shape shape);
  int add_texture(Texture texture);
  int add_material(std::string name, const PhongSurface& surface);
  /// Shows an existing shape, or a new one.
  void show(std::string name, int shape, int material, int node);
  void show(std::string name, Shape shape, int material, int node) {
    show(std::move(name), add_shape(std::move(shape)), material, node);
  }

  /// Turns the node evenly about an axis of its own frame by `turns` whole turns over the loop (negative: clockwise), on top
  /// of its rest rotation, which is `start` of a turn ahead.
  void spin(int node, Vec3f unit_axis, int turns, float start = 0.0f);
  /// Turns the node to and fro about an axis of its own frame, around its rest rotation.
  void swing(int node, Vec3f unit_axis, const Swing& swing);
  /// Moves the node to and fro along a direction of its parent's frame, around its rest place.
  void bob(int node, Vec3f unit_direction, const Swing& swing);

  void add_light(std::string name, Vec3f position, Vec3f color);
  void set_background(Vec3f horizon, Vec3f zenith) { scene_.background = {horizon, zenith, {0.0f, 1.0f, 0.0f}}; }
  void set_max_depth(int vertices) { scene_.max_depth = vertices; }

  /// Hangs a painted cloth far behind the array, square to it: `glow` in its middle, `edge` around. Call after set_display().
  void add_backdrop(Vec3f glow, Vec3f edge);

  /// Stands the array at `center`, seen from `yaw` (to the right) and `pitch` (from above), `viewing_distance` away, and a
  /// camera at that place whose picture is the array's. Returns the array's node.
  int set_display(Vec3f center, float yaw, float pitch, float plane_height, float viewing_distance);

  Scene take() { return std::move(scene_); }

 private:
  NodeAnimation& animation_of(int node);
  Scene scene_;
};

}  // namespace lippmann::builtin
